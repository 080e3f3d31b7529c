#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace mote::test {

/// A mesh of Isshiki (2014), Table 2, with cells beyond its ends.
struct PrintedMesh {
  std::string name;
  int N = 40;
  long double lower = 0, L = 4;
  std::uint64_t seed = 0;
  std::string extension = "formula";
  int beyond = 0;
};

/// Draw number k of SplitMix64 by its own stream, one after the other.
inline long double draw(std::uint64_t seed, int k) {
  std::uint64_t bits = 0;
  for (int n = 0; n <= k; ++n) {
    seed += 0x9E3779B97F4A7C15u;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    bits = z ^ (z >> 31);
  }
  return std::ldexp(static_cast<long double>(bits >> 11), -53);
}

/// dx_i/alpha as printed. The paper's L/100 is for its L/N: both are lengths, so the slope is meant
/// as a share of the line and alpha takes the rest.
inline long double printed_length(const PrintedMesh& mesh, int i) {
  const long double L = mesh.L, N = mesh.N, pi = std::numbers::pi_v<long double>;
  if (mesh.name == "algebraic") return L / N + i * L / 100;
  if (mesh.name == "geometric") return L / N * std::pow(1.05L, i - 1);
  if (mesh.name == "sinusoidal") return L / N * (1 + 0.5L * std::sin(4 * pi * i / N));
  if (mesh.name != "random") return L / N;
  return L / N * (1 + 0.0625L * (i < 0 ? draw(mesh.seed + 1000, -1 - i) : draw(mesh.seed, i)));
}

/// The length of cell i, also beyond the ends, but for alpha; may be negative.
inline long double extended_length(const PrintedMesh& mesh, int i) {
  const int N = mesh.N;
  if (mesh.extension == "constant") i = i < 0 ? 0 : (i < N ? i : N - 1);
  if (mesh.extension == "periodic")
    for (const int step = i < 0 ? N : -N; i < 0 || i >= N;) i += step;
  if (mesh.extension == "mirror")
    while (i < 0 || i >= N) i = i < 0 ? -1 - i : 2 * N - 1 - i;
  return printed_length(mesh, i);
}

struct PrintedCells {
  std::vector<long double> centre, length;  ///< by rising position
};

/// The lengths from the first cell outside an end on; from a length that is not positive the one
/// before is repeated.
inline std::vector<long double> beyond(const PrintedMesh& mesh, int first, int direction) {
  std::vector<long double> lengths;
  long double last = extended_length(mesh, first - direction);
  bool ended = false;
  for (int k = 0; k < mesh.beyond; ++k) {
    const long double length = extended_length(mesh, first + direction * k);
    ended = ended || length <= 1e-15L;
    if (!ended) last = length;
    lengths.push_back(last);
  }
  return lengths;
}

/// All cells: alpha from the sum over i = 0 ... N-1, places as midpoints (57).
inline PrintedCells printed_cells(const PrintedMesh& mesh) {
  const auto below = beyond(mesh, -1, -1), above = beyond(mesh, mesh.N, 1);
  PrintedCells cells{{}, {below.rbegin(), below.rend()}};
  long double sum = 0, edge = mesh.lower;
  for (int i = 0; i < mesh.N; ++i) sum += printed_length(mesh, i);
  for (int i = 0; i < mesh.N; ++i) cells.length.push_back(printed_length(mesh, i));
  cells.length.insert(cells.length.end(), above.begin(), above.end());
  for (long double& length : cells.length) length *= mesh.L / sum;
  for (int k = 0; k < mesh.beyond; ++k) edge -= cells.length[static_cast<std::size_t>(k)];
  for (const long double length : cells.length) {
    cells.centre.push_back(edge + length / 2);
    edge += length;
  }
  return cells;
}

}  // namespace mote::test

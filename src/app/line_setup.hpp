#pragma once

#include <memory>
#include <string>

#include "mote/catalogue/entries.hpp"
#include "mote/scenario/scenario.hpp"

namespace mote {

/// The scenario's initial expressions as a function, with an InputError where one has no value.
InitialValue initial_value(const Scenario& scenario);

/// All that a model on a line is made from but the operator. Throws InputError for cells too small
/// for numbers.
LineStart line_start(const Scenario& scenario, const Catalogue& catalogue);

/// The same with every cell in this many pieces.
LineStart divided(LineStart start, int pieces);

/// What the scenario's model on a line is made from; takes its operator.
LineSetup line_setup(Scenario& scenario, const Catalogue& catalogue);

/// The start of the run on finer cells. Standing points see the gas between the particles too, and
/// the particles' own cells would be too coarse a measure of that.
std::unique_ptr<Model> finely_divided(const Scenario& scenario, const Catalogue& catalogue);

/// What is to be said where the operator reaches beyond the cells at the ends; empty if it does
/// not. Throws InputError if it cannot do without the cells beyond.
std::string missing_neighbours(const Scenario& scenario);

/// Memory of a run on a line, about. [bytes]
double memory_on_a_line(const Scenario& scenario);

}  // namespace mote

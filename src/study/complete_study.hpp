#pragma once

#include "mote/scenario/document.hpp"
#include "mote/study/study_file.hpp"

namespace mote {

/// Checks what no single key of a study file can state, and fills in the defaults that depend on
/// several, exact derivatives among them. Throws LocatedError.
void complete(StudyFile& study, const Document& document);

}  // namespace mote

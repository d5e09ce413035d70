#pragma once
#include "core/truth/variants.h"

namespace rasterlens::cli
{

/// The variants of a list of ids joined by commas, each once.
///
/// errors  throws Failure: an id there is not, with the most similar one; a comma without one
[[nodiscard]] std::vector<const Variant*> variantsOf(const QString& list, const QString& verb);

} // namespace rasterlens::cli

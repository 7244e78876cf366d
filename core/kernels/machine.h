#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kerf {

/// The kinds of vectors that the kernels are compiled for and that this machine has, the widest first, for
/// example "AVX2" or "EMU128" (the baseline: Highway's emulation, which every machine has).
std::vector<std::string> kernels();
/// The kind in use: the widest, unless `use_kernel` chose another.
std::string kernel();
/// Makes all kernels use one kind of vectors, or the widest again if `name` is empty. All compute the same
/// bits. Must not run while another thread is in a kernel. Throws std::invalid_argument, with the known
/// names.
void use_kernel(std::string_view name);

}  // namespace kerf

#pragma once

#include <string>
#include <vector>

namespace berg::test {

using Ids = std::vector<std::string>;

} // namespace berg::test

#pragma once

#include <functional>
#include <string_view>

namespace berg {

/** Takes a long text in pieces, such as `StagedFile::append`. */
using TextSink = std::function<void(std::string_view)>;

} // namespace berg

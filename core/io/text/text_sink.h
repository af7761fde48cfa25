#pragma once

#include <functional>
#include <string_view>

namespace berg {

/** Receives a long text in pieces, e.g. `StagedFile::append`. */
using TextSink = std::function<void(std::string_view)>;

} // namespace berg

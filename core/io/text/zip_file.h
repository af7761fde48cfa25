#pragma once

#include "core/io/text/read_budget.h"
#include "core/io/text/text_sink.h"

#include <functional>
#include <string>
#include <string_view>

namespace berg {

/**
 * A zip archive with one entry, which `write` puts. It holds no time, so that equal contents are
 * equal bytes. Of any length: throws as `Spool`.
 */
void writeZip(const std::string& entryName, const std::function<void(const TextSink&)>& write,
              const TextSink& put);

[[nodiscard]] inline bool isZip(std::string_view bytes)
{
    return bytes.starts_with("PK\x03\x04");
}

/**
 * The first entry whose name ends with `ending`, in letters of either case. Throws `Error`
 * WrongFormat when there is none or the archive cannot be read, and what the budget of the archive
 * throws, of which the text takes.
 */
[[nodiscard]] std::string unzipped(std::string_view bytes, std::string_view ending,
                                   ReadBudget& budget);

} // namespace berg

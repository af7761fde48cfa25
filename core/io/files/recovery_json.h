#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace berg {

/** What is kept about unsaved work beside its scenario; of a file without it, empty. */
struct RecoveryNote
{
    std::string originalPath; ///< file that the scenario belongs to
    std::string editedUtc;    ///< ISO 8601
    std::int64_t pid = 0;     ///< of the program that wrote it
    std::string host;

    bool operator==(const RecoveryNote&) const = default;
};

[[nodiscard]] std::string recoveryToJson(const RecoveryNote& note);

/** `subject` names the text in errors. Throws `Error`: SyntaxError, InvalidInput. */
[[nodiscard]] RecoveryNote recoveryFromJson(std::string_view text, const std::string& subject);

} // namespace berg

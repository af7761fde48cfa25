#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace berg {

/**
 * Note stored beside the recovery copy of an unsaved scenario; members missing in the file are
 * empty.
 */
struct RecoveryNote
{
    std::string originalPath; ///< file that the scenario belongs to
    std::string editedUtc;    ///< time of the last edit, ISO 8601
    std::int64_t pid = 0;     ///< process id of the program that wrote the note
    std::string host;

    bool operator==(const RecoveryNote&) const = default;
};

/** Returns the text of a recovery note. */
[[nodiscard]] std::string recoveryToJson(const RecoveryNote& note);

/**
 * Reads a recovery note; `subject` names the text in errors. Throws `Error`: FileTooLarge,
 * SyntaxError, WrongFormat (UTF-16), InvalidInput.
 */
[[nodiscard]] RecoveryNote recoveryFromJson(std::string_view text, const std::string& subject);

} // namespace berg

#include "core/io/import/fields/import_source.h"

#include "core/base/error.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/text/text_encoding.h"
#include "core/scenario/text_checks.h"

namespace berg {

namespace {

/** Throws if the bytes are not text, with a reason that helps the user. */
void requireText(std::string_view bytes, const std::string& subject)
{
    const auto fail = [&](IssueId reason) {
        throw Error(ErrorCode::WrongFormat, subject, {reason});
    };
    if (trimmed(bytes).empty())
        fail(IssueId::FileEmpty);
    if (bytes.find('\0') != std::string_view::npos)
        fail(IssueId::NotText);
}

} // namespace

std::string textOfBytes(std::string_view bytes, const std::string& subject)
{
    if (isUtf16(bytes)) {
        std::optional<std::string> text = utf8FromUtf16(bytes);
        if (!text)
            throw Error(ErrorCode::WrongFormat, subject, {IssueId::Utf16});
        requireText(*text, subject);
        return std::move(*text);
    }
    requireText(bytes, subject);
    return isUtf8(bytes) ? std::string() : utf8FromWindows(bytes);
}

} // namespace berg

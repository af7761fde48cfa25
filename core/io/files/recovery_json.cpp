#include "core/io/files/recovery_json.h"

#include "core/io/text/json_reader.h"
#include "core/io/text/json_writer.h"

namespace berg {

std::string recoveryToJson(const RecoveryNote& note)
{
    JsonObject object;
    object.add("original_path", note.originalPath);
    object.add("edited_utc", note.editedUtc);
    object.add("pid", note.pid);
    object.add("host", note.host);
    return object.inLines(0) + '\n';
}

RecoveryNote recoveryFromJson(std::string_view text, const std::string& subject)
{
    constexpr WholeLimits kPids{.low = 0, .high = std::int64_t{1} << 32};
    ReadBudget budget(subject, text.size());
    ParsedJson file = parseJson(text, budget);
    ObjectReader object(file.root, "", file.faults);
    RecoveryNote note{.originalPath = object.text("original_path"),
                      .editedUtc = object.text("edited_utc"),
                      .pid = object.whole("pid", 0, kPids),
                      .host = object.text("host")};
    file.faults.throwIfAny(subject);
    return note;
}

} // namespace berg

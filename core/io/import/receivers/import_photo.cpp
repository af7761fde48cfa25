#include "core/io/import/fields/import_fields.h"
#include "core/io/import/receivers/photo_exif.h"
#include "core/io/import/receivers/receiver_readers.h"

namespace berg {

bool isPhoto(std::string_view bytes)
{
    return bytes.starts_with("\xFF\xD8\xFF"); // the marks that begin a JPEG
}

SightingTable readPhoto(const ImportText& source)
{
    const PhotoData photo = photoData(source.text, source.budget.subject());
    SightingTable table;
    if (!photo.place) {
        table.rejected.add({.line = 1, .fault = IssueId::PhotoNoPlace});
        return table;
    }
    if (!photo.time)
        table.noted.add({.line = 1, .fault = IssueId::TimeNotGiven});
    addRow(table, Sighting{.line = 1, .time = photo.time, .place = *photo.place}, source.budget);
    return table;
}

} // namespace berg

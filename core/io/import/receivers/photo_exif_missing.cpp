// Stands in for photo_exif.cpp in a build without libexiv2.

#include "core/base/error.h"
#include "core/io/import/receivers/photo_exif.h"

namespace berg {

bool readsPhotos()
{
    return false;
}

PhotoData photoData(std::string_view /*bytes*/, const std::string& subject)
{
    throw Error(ErrorCode::Unsupported, subject, {IssueId::PhotoNoReader});
}

} // namespace berg

#include "core/io/import/import_file.h"

#include "core/base/error.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/import_formats.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/ogr2ogr.h"
#include "core/io/text/zip_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace berg {

namespace {

/** Returns the first bytes of a regular file; empty for anything else. */
std::string headOf(const std::string& path)
{
    constexpr std::size_t kHead = 1U << 16U;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || isOpenDescriptor(path))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string head(kHead, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

/** Whether one of our own readers takes the file. */
bool isOwnFormat(const std::string& bytes, const std::string& subject, const std::stop_token& stop)
{
    if (isZip(bytes)) {
        ReadBudget budget(subject, bytes.size(), stop);
        return !ZipReader(bytes, budget).names(".kml").empty();
    }
    try {
        const std::string decoded = textOfXml(bytes, subject);
        const std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
        return std::ranges::any_of(
            importFormats(), [text](const ImportFormat& format) { return format.matches(text); });
    } catch (const Error&) {
        return false; // it is not text
    }
}

} // namespace

std::string readImportFile(const std::string& path, const std::string& subject,
                           const std::stop_token& stop)
{
    if (hasGisContent(headOf(path)))
        return geoJsonOfGisFile(path, subject, stop);
    std::string bytes = readFile(path, stop);
    if (!hasGisEnding(path) || isOwnFormat(bytes, subject, stop))
        return bytes;
    return geoJsonOfGisFile(path, subject, stop);
}

bool isGisFileName(const std::string& name)
{
    return hasGisEnding(name);
}

} // namespace berg

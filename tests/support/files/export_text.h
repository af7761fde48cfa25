#pragma once

// Complete exports and archives as texts.

#include "core/io/export/formats.h"
#include "core/io/text/zip_file.h"

#include <string>
#include <string_view>

namespace berg {

inline std::string geoJson(const ExportContent& content)
{
    return findExportFormat("geojson")->text(content);
}

inline std::string gpxText(const ExportContent& content)
{
    return findExportFormat("gpx")->text(content);
}

inline std::string kmlText(const ExportContent& content)
{
    return findExportFormat("kml")->text(content);
}

inline std::string kmzFile(const ExportContent& content)
{
    return findExportFormat("kmz")->text(content);
}

inline std::string czmlText(const ExportContent& content)
{
    return findExportFormat("czml")->text(content);
}

inline std::string zipFile(const std::string& entryName, std::string_view content)
{
    std::string archive;
    writeZip(
        entryName, [content](const TextSink& put) { put(content); },
        [&archive](std::string_view piece) { archive += piece; });
    return archive;
}

} // namespace berg

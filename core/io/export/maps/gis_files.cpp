#include "core/io/export/maps/map_writers.h"
#include "core/io/text/ogr2ogr.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

void writeGis(const ExportContent& content, GisFormat format, const TextSink& put)
{
    constexpr int kWgs84 = 4326;
    const bool isDrawing = format == GisFormat::Dxf;
    std::string geoJson;
    writeFlatGeoJson(content, isDrawing ? FlatProperties::Layer : FlatProperties::Values,
                     [&geoJson](std::string_view piece) { geoJson += piece; });
    put(gisFileOfGeoJson(geoJson, format, isDrawing ? utmEpsg(content.frame.origin()) : kWgs84,
                         "format"));
}

} // namespace

void writeShapefiles(const ExportContent& content, const TextSink& put)
{
    writeGis(content, GisFormat::Shapefile, put);
}

void writeGeoPackage(const ExportContent& content, const TextSink& put)
{
    writeGis(content, GisFormat::GeoPackage, put);
}

void writeGml(const ExportContent& content, const TextSink& put)
{
    writeGis(content, GisFormat::Gml, put);
}

void writeDxf(const ExportContent& content, const TextSink& put)
{
    writeGis(content, GisFormat::Dxf, put);
}

void writeFlatGeobuf(const ExportContent& content, const TextSink& put)
{
    writeGis(content, GisFormat::FlatGeobuf, put);
}

int utmEpsg(const LatLon& place)
{
    constexpr double kNorthEnd_deg = 84;
    constexpr double kSouthEnd_deg = -80;
    constexpr int kUpsNorth = 32661;
    constexpr int kUpsSouth = 32761;
    constexpr int kUtmNorth = 32600;
    constexpr int kUtmSouth = 32700;
    if (place.latitude_deg > kNorthEnd_deg)
        return kUpsNorth;
    if (place.latitude_deg < kSouthEnd_deg)
        return kUpsSouth;
    const int zone =
        std::clamp(static_cast<int>(std::floor((place.longitude_deg + 180) / 6)) + 1, 1, 60);
    return (place.latitude_deg < 0 ? kUtmSouth : kUtmNorth) + zone;
}

} // namespace berg

#include "core/io/import/fields/import_xml.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/fields/import_source.h"
#include "core/io/text/byte_order_mark.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

/** Returns the end of the declaration, comment or instruction with which a text begins. */
std::size_t prologEnd(std::string_view text)
{
    std::string_view mark = ">";
    if (text.starts_with("<?"))
        mark = "?>";
    else if (text.starts_with("<!--"))
        mark = "-->";
    else if (text.substr(0, text.find('>')).find('[') != std::string_view::npos)
        mark = "]>"; // document type with entities
    const std::size_t end = text.find(mark);
    return end == std::string_view::npos ? text.size() : end + mark.size();
}

/** Whether the bytes declare an encoding that is neither UTF-8 nor Latin. */
bool declaresOther(std::string_view bytes)
{
    constexpr std::string_view kWord = "encoding";
    const std::string_view head = bytes.substr(0, std::min(bytes.find("?>"), bytes.size()));
    const std::size_t at = head.find(kWord);
    if (!trimmed(withoutByteOrderMark(head)).starts_with("<?xml") || at == std::string_view::npos)
        return false;
    const std::size_t open = std::min(head.find_first_of("'\"", at), head.size() - 1);
    const std::size_t end = std::min(head.find_first_of("'\"", open + 1), head.size());
    const std::string name = plainName(head.substr(open + 1, end - open - 1));
    constexpr std::array<std::string_view, 9> kRead = {
        "utf8", "usascii", "ascii", "iso88591", "latin1", "windows1252", "cp1252", "iso885915", ""};
    return std::ranges::find(kRead, name) == kRead.end();
}

} // namespace

std::string_view parentName(XmlPath path)
{
    return path.size() < 2 ? std::string_view() : path[path.size() - 2].name;
}

std::optional<std::vector<LatLon>> placesOfTuples(std::string_view tuples)
{
    std::vector<LatLon> places;
    for (std::string_view rest = trimmed(tuples); !rest.empty(); rest = trimmed(rest)) {
        const std::string_view tuple = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const std::size_t comma = std::min(tuple.find(','), tuple.size() - 1);
        const std::string_view second = tuple.substr(comma + 1);
        const std::optional<LatLon> place =
            scenePlaceOf(second.substr(0, second.find(',')), tuple.substr(0, comma));
        if (!place)
            return std::nullopt;
        places.push_back(*place);
        rest.remove_prefix(tuple.size());
    }
    return places;
}

bool rootIs(std::string_view text, std::string_view name)
{
    std::string_view rest = trimmed(withoutByteOrderMark(text));
    while (rest.starts_with("<?") || rest.starts_with("<!"))
        rest = trimmed(rest.substr(prologEnd(rest)));
    if (!rest.starts_with('<'))
        return false;
    const std::string_view whole = rest.substr(1, rest.find_first_of(" \t\r\n/>", 1) - 1);
    return whole.substr(whole.rfind(':') + 1) == name; // npos + 1 is 0
}

std::string textOfXml(std::string_view bytes, const std::string& subject)
{
    std::string decoded = textOfBytes(bytes, subject);
    const bool isXml = rootIs(bytes, "kml") || rootIs(bytes, "gpx");
    if (isXml && !decoded.empty() && declaresOther(bytes))
        decoded.clear();
    return decoded;
}

} // namespace berg

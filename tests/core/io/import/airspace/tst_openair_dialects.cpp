#include "core/base/random.h"
#include "core/geometry/geometry.h"
#include "core/io/import/airspace/import_airspace.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <cmath>
#include <map>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kMile_m = 1852;
constexpr double kOneDegree_rad = 0.017453292519943295;

/** Style of an airspace file. */
struct Dialect
{
    std::string lineEnd = "\n";
    int angle = 0;         ///< seconds, seconds with decimals, minutes, degrees, letters in front
    bool isSmall = false;  ///< records in lower case
    bool isTight = false;  ///< no blanks behind tags and before letters
    bool hasComma = false; ///< decimals behind commas
    bool hasComments = false;
    bool hasColours = false;
    int height = 0;
};

Dialect anyDialect(Random& random)
{
    const auto one = [&](int count) { return static_cast<int>(random.uniform() * count); };
    const std::array<std::string, 3> ends{"\n", "\r\n", "\r"};
    Dialect dialect{.lineEnd = ends.at(static_cast<std::size_t>(one(3))),
                    .angle = one(5),
                    .isSmall = one(4) == 0,
                    .isTight = one(3) == 0,
                    .hasComma = one(3) == 0,
                    .hasComments = one(2) == 0,
                    .hasColours = one(2) == 0,
                    .height = one(7)};
    return dialect;
}

std::string textOf(const char* pattern, auto... values)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

/** Sometimes writes seconds of 60, as files with rounded values have. */
std::string angleText(double angle_deg, const char* letters, const Dialect& dialect)
{
    const double size_deg = std::abs(angle_deg);
    const char* const letter = angle_deg < 0 ? letters + 1 : letters;
    const auto whole = static_cast<int>(size_deg);
    const double minutes = (size_deg - whole) * 60;
    std::string text;
    if (dialect.angle == 2) {
        text = textOf("%02d:%09.6f", whole, minutes);
    } else if (dialect.angle == 3) {
        text = textOf("%.8f", size_deg);
    } else {
        const auto minute = static_cast<int>(minutes);
        text = textOf("%02d:%02d:%09.6f", whole, minute, (minutes - minute) * 60);
    }
    if (dialect.hasComma)
        for (char& c : text)
            c = c == '.' ? ',' : c;
    if (dialect.angle == 4)
        return std::string(1, *letter) + text;
    return text + (dialect.isTight ? "" : " ") + *letter;
}

std::string placeText(const LatLon& place, const Dialect& dialect)
{
    return angleText(place.latitude_deg, "NS", dialect) + ' ' +
           angleText(place.longitude_deg, "EW", dialect);
}

std::string numberText(double number, const Dialect& dialect)
{
    std::string text = textOf("%.4f", number);
    if (dialect.hasComma)
        text[text.find('.')] = ',';
    return text;
}

std::string heightText(int feet, const Dialect& dialect)
{
    const int thousands = feet / 1000;
    const int rest = feet % 1000;
    switch (dialect.height) {
    case 0:
        return textOf("%d ft MSL", feet);
    case 1:
        return textOf("%dft AGL", feet);
    case 2:
        return textOf("FL %d", feet / 100);
    case 3:
        return textOf("%d FL", feet / 100);
    case 4:
        return thousands > 0 ? textOf("%d %03d ft MSL", thousands, rest) : textOf("%d ft", rest);
    case 5:
        return thousands > 0 ? textOf("%d,%03d FT", thousands, rest) : textOf("%d", rest);
    default:
        return textOf("%.4f M AMSL", feet * 0.3048);
    }
}

/** An area known by construction. */
struct KnownArea
{
    std::string name;
    std::string kind;
    int floor_ft = 0;
    int ceiling_ft = 0;
    std::vector<Point> true_m; ///< corners, with very many on curves
    std::string shape;         ///< its records in the dialect
};

class AreaWriter
{
public:
    AreaWriter(Random& random, const Dialect& dialect, const LocalFrame& frame)
        : m_random(random), m_dialect(dialect), m_frame(frame)
    {
    }

    KnownArea write(int number)
    {
        KnownArea area{.name = "Area " + std::to_string(number),
                       .kind = std::string(1, "ACDEGRQP"[number % 8]),
                       .floor_ft = 100 * static_cast<int>(m_random.uniform(0, 30)),
                       .ceiling_ft = 100 * static_cast<int>(m_random.uniform(31, 90)),
                       .true_m = {},
                       .shape = {}};
        m_centre_m = {m_random.uniform(-40e3, 40e3), m_random.uniform(-40e3, 40e3)};
        switch (static_cast<int>(m_random.uniform() * 4)) {
        case 0:
            polygon(area);
            break;
        case 1:
            circle(area);
            break;
        case 2:
            sector(area, false);
            break;
        default:
            sector(area, true);
        }
        return area;
    }

    std::string record(const std::string& tag, const std::string& value)
    {
        std::string written = tag;
        if (m_dialect.isSmall)
            for (char& c : written)
                c = static_cast<char>(std::tolower(c));
        const bool isNumber = !value.empty() && std::isdigit(value.front());
        const bool isShape = tag.front() == 'D';
        return written + (m_dialect.isTight && isNumber && isShape ? "" : " ") + value +
               (m_dialect.hasComments && m_random.uniform() < 0.3 ? " * a comment, 47:00 N" : "") +
               m_dialect.lineEnd;
    }

private:
    void polygon(KnownArea& area)
    {
        const int corners = 3 + static_cast<int>(m_random.uniform() * 9);
        const bool isClockwise = m_random.uniform() < 0.5;
        for (int i = 0; i < corners; ++i) {
            const double bearing_rad =
                2 * std::acos(-1.0) * (isClockwise ? i : corners - i) / corners;
            const double radius_m = m_random.uniform(2e3, 15e3);
            area.true_m.emplace_back(
                m_centre_m + radius_m * Point(std::sin(bearing_rad), std::cos(bearing_rad)));
            area.shape +=
                record("DP", placeText(m_frame.toGeographic(area.true_m.back()), m_dialect));
        }
    }

    void circle(KnownArea& area)
    {
        const double radius = m_random.uniform(1, 8);
        const LatLon centre = m_frame.toGeographic(m_centre_m);
        area.shape = record("V", "X=" + placeText(centre, m_dialect)) +
                     record("DC", numberText(radius, m_dialect));
        appendArc(area, centre, radius, 0, 360);
    }

    /** Adds a sector of a circle, by bearings or by its corners, in either sense. */
    void sector(KnownArea& area, bool byPlaces)
    {
        const double radius = m_random.uniform(1, 8);
        const LatLon centre = m_frame.toGeographic(m_centre_m);
        const bool isClockwise = m_random.uniform() < 0.5;
        const double from_deg = std::floor(m_random.uniform(0, 360));
        const double turn_deg = std::floor(m_random.uniform(20, 340)) * (isClockwise ? 1 : -1);
        const double to_deg = std::fmod(from_deg + turn_deg + 720, 360);
        area.true_m.push_back(m_frame.toPlane(centre));
        area.shape = record("V", "D=" + std::string(isClockwise ? "+" : "-")) +
                     record("V", "X=" + placeText(centre, m_dialect)) +
                     record("DP", placeText(centre, m_dialect));
        appendArc(area, centre, radius, from_deg, turn_deg);
        if (byPlaces)
            area.shape +=
                record("DB", placeText(m_frame.toGeographic(area.true_m[1]), m_dialect) + ", " +
                                 placeText(m_frame.toGeographic(area.true_m.back()), m_dialect));
        else
            area.shape += record("DA", numberText(radius, m_dialect) + ", " +
                                           textOf("%.0f, %.0f", from_deg, to_deg));
    }

    void appendArc(KnownArea& area, const LatLon& centre, double radius, double from_deg,
                   double turn_deg)
    {
        const LocalFrame about(centre);
        for (int i = 0; i <= 720; ++i) {
            const double bearing_rad = (from_deg + turn_deg * i / 720) * kOneDegree_rad;
            area.true_m.push_back(m_frame.toPlane(about.toGeographic(
                radius * kMile_m * Point(std::sin(bearing_rad), std::cos(bearing_rad)))));
        }
    }

    Random& m_random;
    const Dialect& m_dialect;
    const LocalFrame& m_frame;
    Point m_centre_m = Point::Zero();
};

double areaOf(const std::vector<Point>& corners_m)
{
    return std::abs(signedArea(corners_m));
}

/** Whether the outline covers all corners and edges, up to decimetres. */
bool covers(const std::vector<Point>& outline_m, const std::vector<Point>& true_m)
{
    for (std::size_t i = 0; i < true_m.size(); ++i)
        for (const double part : {0.0, 0.5}) {
            const Point place_m = true_m[i] + part * (true_m[(i + 1) % true_m.size()] - true_m[i]);
            if (!insidePolygon(outline_m, place_m) && distanceToEdges(outline_m, place_m) > 0.3)
                return false;
        }
    return true;
}

} // namespace

/** Areas known by construction, written in many dialects of OpenAir. */
class TestOpenairDialects : public QObject
{
    Q_OBJECT

private slots:
    /** Each area gives an outline that covers the true one and is hardly larger. */
    void areasAreRecovered()
    {
        const Scenario base = emptySea();
        const LocalFrame frame(base.origin);
        Random random(4906);
        for (int file = 0; file < 150; ++file) {
            const Dialect dialect = anyDialect(random);
            AreaWriter writer(random, dialect, frame);
            std::string text = dialect.hasComments ? "* a file" + dialect.lineEnd : "";
            std::map<std::string, KnownArea> known;
            for (int i = 0; i < 6; ++i) {
                const KnownArea area = writer.write(i);
                text += writer.record("AC", area.kind) + writer.record("AN", area.name) +
                        writer.record("AL", heightText(area.floor_ft, dialect)) +
                        writer.record("AH", heightText(area.ceiling_ft, dialect)) +
                        (dialect.hasColours ? writer.record("SP", "0,1,0,0,255") : "") + area.shape;
                known.emplace(area.name, area);
            }
            const AirspaceResult result = importAirspace(base, text, "file");
            QVERIFY2(result.added == known.size() && result.rejected.count == 0, text.c_str());
            for (const AirspaceArea& read : result.scenario.airspace) {
                const KnownArea& area = known.at(read.name);
                QCOMPARE(read.kind, area.kind);
                QVERIFY2(std::abs(read.floor_m - area.floor_ft * 0.3048) < 1e-3, text.c_str());
                QVERIFY2(std::abs(read.ceiling_m.value_or(-1) - area.ceiling_ft * 0.3048) < 1e-3,
                         text.c_str());
                QVERIFY2(covers(read.corners_m, area.true_m), (read.name + '\n' + text).c_str());
                QVERIFY2(areaOf(read.corners_m) < 1.002 * areaOf(area.true_m),
                         (read.name + '\n' + text).c_str());
            }
        }
    }

    /** With a damaged line, each area is right or is rejected by its name. */
    void spoiltLinesCostTheirAreaAlone()
    {
        const Scenario base = emptySea();
        const LocalFrame frame(base.origin);
        Random random(4907);
        const std::array<std::string, 9> spoilt{"DP 47:61:00 N 048:00:00 W",
                                                "DP 47:00:00 048:00:00",
                                                "DP 47:00:00 N",
                                                "DC 47:00:00 N 048:00:00 W",
                                                "DC 3 furlongs",
                                                "DA 3,90",
                                                "DB 47:00:00 N 048:00:00 W",
                                                "D P 47:00:00 N 048:00:00 W",
                                                "Dp47.3:20N 048:00 W"};
        for (int file = 0; file < 90; ++file) {
            const Dialect dialect = anyDialect(random);
            AreaWriter writer(random, dialect, frame);
            std::string text;
            std::map<std::string, KnownArea> known;
            for (int i = 0; i < 4; ++i) {
                const KnownArea area = writer.write(i);
                text += writer.record("AC", i == 2 ? "" : area.kind) +
                        writer.record("AN", area.name) + writer.record("AL", "GND") +
                        writer.record("AH", heightText(area.ceiling_ft, dialect)) + area.shape;
                if (i == 1)
                    text +=
                        spoilt.at(static_cast<std::size_t>(file) % spoilt.size()) + dialect.lineEnd;
                known.emplace(area.name, area);
            }
            const AirspaceResult result = importAirspace(base, text, "file");
            QVERIFY2(result.added == 3 && result.rejected.count == 1, text.c_str());
            QVERIFY(result.rejected.first[0].detail.starts_with("Area 1: "));
            QCOMPARE(result.noted.count, std::size_t{1}); // the third has no class
            for (const AirspaceArea& read : result.scenario.airspace) {
                const KnownArea& area = known.at(read.name);
                QVERIFY(covers(read.corners_m, area.true_m));
                QVERIFY(areaOf(read.corners_m) < 1.002 * areaOf(area.true_m));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestOpenairDialects)
#include "tst_openair_dialects.moc"

#include "core/base/angles.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"
#include "widgets/map/paint/swept_layer.h"

#include <QPainter>
#include <QtTest>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr QSize kSize(400, 300);
const QColor kTint(0, 120, 110, 40);

SweptStyle seek(const Point& centre_m, double scale_pxpm)
{
    const QRectF rect(QPointF(0, 0), QSizeF(kSize));
    return {
        .view = MapViewTransform(centre_m, rect.center(), scale_pxpm), .rect = rect, .tint = kTint};
}

std::vector<MapPose> posesOf(const Mission& mission)
{
    std::vector<MapPose> poses;
    for (const Sample& sample : mission.recorder().samples())
        poses.push_back({.position_m = sample.uavs[0].pose.position_m,
                         .psi_rad = sample.uavs[0].pose.psi_rad,
                         .time_s = sample.time_s});
    return poses;
}

/** Ten minutes among icebergs close by, so that there is much turning. */
Mission tenMinutes(double interval_s)
{
    Scenario scenario = randomScenario(11, {.icebergs = 8});
    scenario.duration_s = 600;
    scenario.planner.policy = PolicyKind::Nearest;
    Mission mission(scenario, {.sampleInterval_s = interval_s});
    mission.advance(scenario.duration_s);
    return mission;
}

std::vector<FieldOfView> fieldsOf(const std::vector<MapPose>& poses, const SensorSpec& sensor)
{
    std::vector<FieldOfView> fields;
    for (const MapPose& pose : poses)
        fields.emplace_back(sensor, pose.position_m, pose.psi_rad);
    return fields;
}

bool isSeen(const std::vector<FieldOfView>& fields, const Point& place_m)
{
    return std::any_of(fields.begin(), fields.end(),
                       [&](const FieldOfView& field) { return field.contains(place_m); });
}

bool isTinted(const QImage& image, int x, int y)
{
    return qAlpha(image.pixel(x, y)) > 0;
}

Point placeOf(const SweptStyle& style, int x, int y)
{
    return style.view.toWorld(QPointF(x + 0.5, y + 0.5) / style.ratio);
}

int differences(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += isTinted(a, x, y) != isTinted(b, x, y) ? 1 : 0;
    return count;
}

} // namespace

class TestSweptMask : public QObject
{
    Q_OBJECT

private slots:
    /** 2 km east with a field of 600 m along and 200 m across. */
    void straightPathIsARectangle()
    {
        const SensorSpec sensor{.fov_m = {600, 200}};
        const SweptStyle style = seek({1000, 0}, 0.1);
        const std::vector<MapPose> poses{{.position_m = {0, 0}},
                                         {.position_m = {700, 0}, .time_s = 30},
                                         {.position_m = {2000, 0}, .time_s = 90}};
        SweptMask mask;
        const QImage& image = mask.updated({{poses, sensor}}, style);
        QCOMPARE(image.size(), kSize);
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const Point place_m = placeOf(style, x, y);
                const bool inside =
                    place_m.x() > -300 && place_m.x() < 2300 && std::abs(place_m.y()) < 100;
                QCOMPARE(isTinted(image, x, y), inside);
            }
    }

    void againstTheFlightItself_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("scale_pxpm");
        QTest::addColumn<double>("interval_s");
        QTest::addColumn<double>("slack_px"); ///< that an edge may be off
        const std::array<const char*, 3> names{"body", "north", "disk"};
        for (int shape = 0; shape < 3; ++shape) {
            const char* name = names[static_cast<std::size_t>(shape)];
            QTest::addRow("%s, far", name) << shape << 0.05 << 1.0 << 1.5;
            QTest::addRow("%s, near", name) << shape << 0.3 << 1.0 << 2.0;
            // The turn rate changes within an interval: metres along the path, 0.1 px each.
            QTest::addRow("%s, few samples", name) << shape << 0.1 << 5.0 << 2.5;
        }
    }

    /** Pixels against the field of view at moments close to each other. */
    void againstTheFlightItself()
    {
        QFETCH(int, shape);
        QFETCH(double, scale_pxpm);
        QFETCH(double, interval_s);
        QFETCH(double, slack_px);
        const SensorSpec sensor{.fov_m = {500, 300}, .shape = static_cast<FovShape>(shape)};
        const std::vector<MapPose> steps = posesOf(tenMinutes(0.2));
        const std::vector<MapPose> poses = posesOf(tenMinutes(interval_s));
        const SweptStyle style = seek(steps[steps.size() / 2].position_m, scale_pxpm);
        SweptMask mask;
        const QImage& image = mask.updated({{poses, sensor}}, style);
        const double slack_m = slack_px / scale_pxpm;
        const Point ring_m = Point::Constant(2 * slack_m);
        const std::vector<FieldOfView> smaller =
            fieldsOf(steps, {.fov_m = sensor.fov_m - ring_m, .shape = sensor.shape});
        const std::vector<FieldOfView> larger =
            fieldsOf(steps, {.fov_m = sensor.fov_m + ring_m, .shape = sensor.shape});
        int tinted = 0;
        for (int y = 0; y < image.height(); y += 5)
            for (int x = 0; x < image.width(); x += 5) {
                const Point place_m = placeOf(style, x, y);
                const bool shown = isTinted(image, x, y);
                tinted += shown ? 1 : 0;
                if (shown ? !isSeen(larger, place_m) : isSeen(smaller, place_m))
                    QFAIL(qPrintable(u"%1 at %2, %3"_s.arg(shown).arg(x).arg(y)));
            }
        QVERIFY(tinted > 100); // 4800 pixels are compared
    }

    void overlapsAreNotDarker()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        SweptMask mask;
        const QImage& image = mask.updated({{poses}}, seek(poses.front().position_m, 0.1));
        const QRgb tint = qPremultiply(kTint.rgba());
        int tinted = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QRgb pixel = reinterpret_cast<const QRgb*>(image.constScanLine(y))[x];
                QVERIFY(pixel == 0 || pixel == tint);
                tinted += pixel == tint ? 1 : 0;
            }
        QVERIFY(tinted > 1000);
    }

    /** Grown sample by sample, with an instant between two of them at its end now and then. */
    void growingIsPaintingAnew()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        const SweptStyle style = seek(poses.front().position_m, 0.1);
        SweptMask grown;
        for (std::size_t count = 2; count <= poses.size(); ++count) {
            std::vector<MapPose> known(poses.begin(),
                                       poses.begin() + static_cast<std::ptrdiff_t>(count));
            if (count % 3 == 0) {
                const MapPose& before = poses[count - 2];
                MapPose& last = known.back();
                last.position_m = 0.5 * (last.position_m + before.position_m);
                last.time_s = 0.5 * (last.time_s + before.time_s);
            }
            static_cast<void>(grown.updated({{known}}, style));
        }
        SweptMask whole;
        const QImage& all = whole.updated({{poses}}, style);
        // Joined pieces are half a pixel off at most; the edges are thousands of pixels long.
        QVERIFY(differences(grown.updated({{poses}}, style), all) < 300);
    }

    /** Looking back there is only what was seen until then, and nothing of what came after. */
    void backInTimeThereIsLess()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        const SweptStyle style = seek(poses.front().position_m, 0.1);
        SweptMask mask;
        static_cast<void>(mask.updated({{poses}}, style));
        for (const std::size_t count : {std::size_t{300}, std::size_t{299}, std::size_t{2}}) {
            const std::span<const MapPose> known(poses.data(), count);
            SweptMask fresh;
            QCOMPARE(differences(mask.updated({{known}}, style), fresh.updated({{known}}, style)),
                     0);
        }
    }

    void changedStyleIsRepainted()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        SweptStyle style = seek(poses.front().position_m, 0.1);
        SensorSpec sensor;
        SweptMask mask;
        static_cast<void>(mask.updated({{poses, sensor}}, style));
        const auto isFresh = [&] {
            SweptMask fresh;
            return mask.updated({{poses, sensor}}, style) ==
                   fresh.updated({{poses, sensor}}, style);
        };
        style.view = style.view.moved({40, -25});
        QVERIFY(isFresh());
        sensor.shape = FovShape::Disk;
        QVERIFY(isFresh());
        style.tint = QColor(200, 100, 0, 60);
        QVERIFY(isFresh());
        style.ratio = 2;
        QVERIFY(isFresh());
        QCOMPARE(mask.updated({{poses}}, style).size(), 2 * kSize);
        QCOMPARE(mask.updated({{poses}}, style).devicePixelRatio(), 2.0);
        style.rect.setSize(QSizeF(120, 80));
        QVERIFY(isFresh());
    }

    /** A little at a time comes to the same as all at once. */
    void paintedInParts()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        const SweptStyle style = seek(poses.front().position_m, 0.1);
        SweptMask mask;
        QVERIFY(!mask.advance({{poses}}, style, 0));
        QVERIFY(mask.isOf({{poses}}));
        int parts = 1;
        while (!mask.advance({{poses}}, style, 0))
            ++parts;
        QVERIFY(parts > 5 && parts < 20); // there are 64 poses
        SweptMask whole;
        QVERIFY(differences(mask.image(), whole.updated({{poses}}, style)) < 100);
    }

    /** After a long flight the last view stands in until the new one is painted. */
    void theLastViewStandsIn()
    {
        std::vector<MapPose> poses; // back and forth over 3 km: more than one frame has time for
        for (int k = 0; k < 400'000; ++k)
            poses.push_back({.position_m = {20.0 * std::abs(k % 300 - 150), 0},
                             .psi_rad = k % 300 < 150 ? kPi : 0,
                             .time_s = 1.0 * k});
        const auto frame = [&](SweptLayer& layer, const SweptStyle& style) {
            QImage image(kSize, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            layer.paint(painter, {{poses}}, style);
            return image;
        };
        SweptLayer layer;
        SweptStyle style = seek({1500, 0}, 0.08);
        QImage shown = frame(layer, style);
        while (!layer.isDone())
            shown = frame(layer, style);
        SweptMask whole;
        QVERIFY(differences(shown, whole.updated({{poses}}, style)) < 100);
        style.view = style.view.moved({0, 50});
        shown = frame(layer, style);
        SweptMask moved;
        QVERIFY(differences(shown, moved.updated({{poses}}, style)) < 1000); // the old one, moved
        while (!layer.isDone())
            shown = frame(layer, style);
        QVERIFY(differences(shown, moved.updated({{poses}}, style)) < 100);
        for (int k = 0; k < 400 && !(k > 3 && layer.isDone()); ++k) { // always on the move
            style.view = style.view.moved({0, k % 2 == 0 ? 1.0 : -1.0});
            shown = frame(layer, style);
        }
        QVERIFY(differences(shown, moved.updated({{poses}}, style)) < 2000);
        poses.resize(30); // looking back it would show what is not seen yet
        SweptMask early;
        QVERIFY(differences(frame(layer, style), early.updated({{poses}}, style)) < 100);
    }

    /** Crossing paths do not darken the water, and each trail continues by itself. */
    void severalUavsInOneTint()
    {
        const std::vector<MapPose> east{{.position_m = {0, 0}},
                                        {.position_m = {1000, 0}, .time_s = 50},
                                        {.position_m = {2000, 0}, .time_s = 100}};
        const std::vector<MapPose> north{
            {.position_m = {1000, -800}, .psi_rad = kPi / 2},
            {.position_m = {1000, 0}, .psi_rad = kPi / 2, .time_s = 50},
            {.position_m = {1000, 800}, .psi_rad = kPi / 2, .time_s = 100}};
        const SensorSpec narrow{.fov_m = {600, 200}};
        const SweptStyle style = seek({1000, 0}, 0.1);
        SweptMask both;
        SweptMask first;
        SweptMask second;
        const QImage& image = both.updated({{east, narrow}, {north}}, style);
        const QImage& ofEast = first.updated({{east, narrow}}, style);
        const QImage& ofNorth = second.updated({{north}}, style);
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                QCOMPARE(image.pixel(x, y),
                         isTinted(ofEast, x, y) ? ofEast.pixel(x, y) : ofNorth.pixel(x, y));
        SweptMask grown;
        const auto until = [](const std::vector<MapPose>& poses, std::size_t count) {
            return std::span(poses).first(count);
        };
        static_cast<void>(grown.updated({{until(east, 2), narrow}, {until(north, 2)}}, style));
        QCOMPARE(grown.updated({{east, narrow}, {north}}, style), image);
        // Back to one of them, the other's water is gone.
        QCOMPARE(grown.updated({{east, narrow}}, style), ofEast);
    }

    void farFromTheMapNothingIsPainted()
    {
        const std::vector<MapPose> poses = posesOf(tenMinutes(1));
        const SweptStyle style = seek({500e3, 500e3}, 10);
        SweptMask mask;
        const QImage& image = mask.updated({{poses}}, style);
        QImage empty(kSize, QImage::Format_ARGB32_Premultiplied);
        empty.fill(Qt::transparent);
        QCOMPARE(image, empty);
    }
};

QTEST_MAIN(TestSweptMask)
#include "tst_swept_mask.moc"

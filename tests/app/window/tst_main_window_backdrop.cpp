#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/paint/map_layers.h"

#include <QFile>
#include <QPushButton>
#include <QStatusBar>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** A polygon all round the scenario. */
QString chartFile(const WindowFixture& w, const LatLon& origin)
{
    const QString path = w.file(u"ice chart.geojson"_s);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        qFatal("no file");
    const auto corner = [&](double east_deg, double north_deg) {
        return u"[%1, %2]"_s.arg(origin.longitude_deg + east_deg)
            .arg(origin.latitude_deg + north_deg);
    };
    const QString ring =
        QStringList{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, -1)}.join(u", "_s);
    file.write(uR"({"type": "Feature", "properties": {"CT": "92"}, "geometry": {"type": "Polygon",
                    "coordinates": [[%1]]}})"_s.arg(ring)
                   .toUtf8());
    return path;
}

QImage settledMap(WindowFixture& w)
{
    static_cast<void>(w.map().grab()); // asks for the ground of this view
    w.map().finishLand();
    return w.map().grab().toImage();
}

} // namespace

/** A file of the user below the map. */
class TestMainWindowBackdrop : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** It may be on a drive that is missing today, or never come back. */
    void aFileThatIsGoneCanBeRemoved()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.settings.setValue("view/backdrop", w.file(u"gone.geojson"_s));
        MainWindow next(w.workspace, w.interaction, w.settings);
        auto& button = test::child<QPushButton>(next, u"backdropButton"_s);
        QTRY_COMPARE(button.text(), u"gone.geojson"_s);
        auto& remove = test::child<QPushButton>(next, u"backdropRemoveButton"_s);
        QVERIFY(!remove.isHidden());
        remove.click();
        QVERIFY(!w.settings.contains("view/backdrop"));
    }

    void isShownRememberedAndRemoved()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const QImage without = settledMap(w);
        auto& opacity = test::child<QSlider>(w.window(), u"backdropLayer"_s);
        QVERIFY(!opacity.isEnabled());
        w.interaction.path = chartFile(w, w.scenario().origin);
        w.trigger(u"backdropAction"_s);
        QVERIFY(w.until([&] { return w.map().layers().backdrop != nullptr; }));
        const QImage with = settledMap(w);
        QVERIFY(with != without);
        QVERIFY(opacity.isEnabled());
        QCOMPARE(opacity.value(), 50); // the field of view is seen on it
        auto& button = test::child<QPushButton>(w.window(), u"backdropButton"_s);
        QCOMPARE(button.text(), u"ice chart.geojson"_s);

        opacity.setValue(0);
        QCOMPARE(settledMap(w), without);
        opacity.setValue(50);
        QCOMPARE(settledMap(w), with);
        {
            const MainWindow next(w.workspace, w.interaction, w.settings);
            QVERIFY(w.until([&] { return next.mapView().layers().backdrop != nullptr; }));
        }
        test::child<QPushButton>(w.window(), u"backdropRemoveButton"_s).click();
        QCOMPARE(settledMap(w), without);
        QVERIFY(!opacity.isEnabled());
        const MainWindow last(w.workspace, w.interaction, w.settings);
        QVERIFY(!w.settings.contains("view/backdrop"));
        QVERIFY(last.mapView().layers().backdrop == nullptr);
    }

    /** Cancelled, of another kind, broken, gone: what was shown stays, and the user knows why. */
    void faultsAreReported()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.interaction.path = chartFile(w, w.scenario().origin);
        w.trigger(u"backdropAction"_s);
        QVERIFY(w.until([&] { return w.map().layers().backdrop != nullptr; }));
        const BackdropPointer shown = w.map().layers().backdrop;
        w.interaction.path.clear();
        w.trigger(u"backdropAction"_s);
        for (const auto& [name, text] : {std::pair(u"table.csv"_s, "a,b\n1,2\n"),
                                         std::pair(u"broken.geojson"_s, "{\"coordinates\": [")}) {
            QFile file(w.file(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
            file.close();
            const qsizetype before = w.interaction.errors.size();
            w.interaction.path = file.fileName();
            w.trigger(u"backdropAction"_s);
            QVERIFY(w.until([&] { return w.interaction.errors.size() > before; }));
            QVERIFY(w.interaction.errors.last().contains(name));
        }
        QVERIFY(w.interaction.errors.front().contains(u"GeoJSON"_s));
        QVERIFY(w.map().layers().backdrop == shown);
    }

    void oneThatIsGoneIsReportedOnce()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.settings.setValue("view/backdrop", w.file(u"gone.kml"_s));
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(
            w.until([&] { return next.statusBar()->currentMessage().contains(u"gone.kml"_s); }));
        QVERIFY(w.interaction.errors.isEmpty());
    }
};

QTEST_MAIN(TestMainWindowBackdrop)
#include "tst_main_window_backdrop.moc"

#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/theme/language.h"

#include <QDockWidget>
#include <QMenu>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

constexpr QPoint kOnTitle(40, 50);
constexpr int kParts_px = 23; ///< from the top of the map: middle of what folds and moves the title

const MapPanelState& stateOf(WindowFixture& w, MapPanel panel)
{
    return w.map().panels().states()[static_cast<std::size_t>(panel)];
}

/** Searches for the fold mark along the upper edge of the title; returns nullopt if the panel did
 * not fold. */
std::optional<int> foldTitle(WindowFixture& w)
{
    for (int x = 60; x < w.map().width() / 2; x += 8) {
        w.click({x, kParts_px});
        if (stateOf(w, MapPanel::Title).isFolded)
            return x;
    }
    return std::nullopt;
}

} // namespace

/** Panels on the map do not cover the objects below them. */
class TestMainWindowPanels : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { installLanguage(u"en"_s); }
    void init() { test::failOnWarnings(); }

    void icebergBelowAPanelIsPickedAndDragged()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.map().camera().panBy(QPointF(kOnTitle) - w.pixelOf("berg-2"));
        QCOMPARE(w.pixelOf("berg-2"), kOnTitle);
        w.click(kOnTitle);
        QVERIFY(w.workspace.selection().contains("berg-2"));
        w.drag(kOnTitle, kOnTitle + QPoint(300, 200));
        QVERIFY((w.pixelOf("berg-2") - kOnTitle - QPoint(300, 200)).manhattanLength() <= 2);
    }

    /** Only where it hides something: else it could not be read. */
    void panelIsFaintBelowThePointer()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Theme theme = Theme::light();
        // This is a place of the title without text.
        const auto isFaint = [&] {
            const QColor ground = w.map().grab().toImage().pixelColor(16, 88);
            return ground.red() < (theme.sea.red() + theme.panel.red()) / 2;
        };
        QTest::mouseMove(&w.map(), {400, 300});
        QVERIFY(!isFaint());
        QTest::mouseMove(&w.map(), kOnTitle);
        QVERIFY(!isFaint());
        w.map().camera().panBy(QPointF(kOnTitle) - w.pixelOf("berg-2"));
        QTest::mouseMove(&w.map(), {400, 300});
        QVERIFY(!isFaint());
        QTest::mouseMove(&w.map(), kOnTitle);
        QVERIFY(isFaint());
    }

    void foldsToAnIconAndBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(foldTitle(w));
        QVERIFY(w.settings.contains(u"view/mapPanels"_s));
        w.click({25, 25}); // the icon
        QVERIFY(!stateOf(w, MapPanel::Title).isFolded);
    }

    void isMovedByItsGrip()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const std::optional<int> fold = foldTitle(w);
        QVERIFY(fold);
        w.click({25, 25});
        // Left of what folds it, which is met at its left edge.
        const QPoint grip(*fold - 10, kParts_px);
        w.drag(grip, grip + QPoint(50, 30));
        QCOMPARE(stateOf(w, MapPanel::Title).moved_px, QPointF(50, 30));
    }

    /** Movement of the mouse beyond the edge is ignored: moving back takes effect at once. */
    void isNotMovedBeyondTheMap()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const std::optional<int> fold = foldTitle(w);
        QVERIFY(fold);
        w.click({25, 25});
        const QPoint grip(*fold - 10, kParts_px);
        w.drag(grip, grip - QPoint(300, 300));
        QCOMPARE(stateOf(w, MapPanel::Title).moved_px, QPointF(0, 0));
    }

    void middleButtonDoesNotLetAPanelGo()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const std::optional<int> fold = foldTitle(w);
        QVERIFY(fold);
        w.click({25, 25});
        const QPoint grip(*fold - 10, kParts_px);
        QTest::mousePress(&w.map(), Qt::LeftButton, {}, grip);
        QTest::mouseMove(&w.map(), grip + QPoint(20, 20));
        QTest::mouseClick(&w.map(), Qt::MiddleButton, {}, grip + QPoint(20, 20));
        QTest::mouseMove(&w.map(), grip + QPoint(50, 30));
        QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, grip + QPoint(50, 30));
        QCOMPARE(stateOf(w, MapPanel::Title).moved_px, QPointF(50, 30));
    }

    /** The second click of a double click is not one on what was below the panel. */
    void doubleClickFoldsOnce()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const std::optional<int> fold = foldTitle(w);
        QVERIFY(fold);
        w.click({25, 25});
        const QPoint button(*fold, kParts_px);
        w.map().camera().panBy(QPointF(button) - w.pixelOf("berg-2"));
        auto& inspector = test::child<QDockWidget>(w.window(), u"inspectorDock"_s);
        QVERIFY(inspector.visibleRegion().isEmpty());
        QTest::mouseClick(&w.map(), Qt::LeftButton, {}, button);
        QTest::mouseDClick(&w.map(), Qt::LeftButton, {}, button);
        QVERIFY(stateOf(w, MapPanel::Title).isFolded);
        QVERIFY(w.workspace.selection().isEmpty());
        QVERIFY(inspector.visibleRegion().isEmpty());
    }

    void brokenSettingsAreNotTakenUp()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.settings.setValue(u"view/mapPanels"_s,
                            QStringList{u"0 0 nan 0"_s, u"0 0 0 inf"_s, u"0 1 5"_s});
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(next.mapView().panels().states() == MapPanelStates());
    }

    void menuFoldsAndHides()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto choose = [&](const QString& text) {
            QTest::mouseClick(&w.map(), Qt::RightButton, {}, kOnTitle);
            auto& menu = test::child<QMenu>(w.window(), u"mapMenu"_s);
            for (QAction* action : menu.actions())
                if (action->text() == text) {
                    action->trigger();
                    menu.close();
                    return QTest::qWaitFor(
                        [&] { return w.window().findChild<QMenu*>(u"mapMenu"_s) == nullptr; });
                }
            return false;
        };
        QVERIFY(choose(u"Fold"_s));
        QVERIFY(stateOf(w, MapPanel::Title).isFolded);
        w.click({25, 25});
        QVERIFY(choose(u"Hide"_s));
        QVERIFY(stateOf(w, MapPanel::Title).isHidden);
        QVERIFY(!w.action(u"titlePanelAction"_s).isChecked());
    }

    /** On a low map there is no room for the legend: its icon opens it all the same. */
    void aLegendWithoutRoomIsOpenedByItsIcon()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        for (int height_px = 700; height_px >= 400 && !w.map().panels().isFolded(MapPanel::Legend);
             height_px -= 20)
            w.window().resize(1000, height_px);
        QVERIFY(w.map().panels().isFolded(MapPanel::Legend));
        QVERIFY(!stateOf(w, MapPanel::Legend).isFolded); // not by the user
        const QPoint icon(25, w.map().height() - 25);
        QCOMPARE(w.map().panels().at(icon), std::optional(MapPanel::Legend));
        w.click(icon);
        QVERIFY(!w.map().panels().isFolded(MapPanel::Legend));
        w.map().panels().fold(MapPanel::Legend);
        QVERIFY(w.map().panels().isFolded(MapPanel::Legend));
        w.click(icon);
        QVERIFY(!w.map().panels().isFolded(MapPanel::Legend));
    }

    void hiddenStaysHidden()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        for (const char* action : {"titlePanelAction", "legendPanelAction", "scalePanelAction",
                                   "northPanelAction", "windPanelAction"})
            w.trigger(QString::fromLatin1(action));
        w.trigger(u"view/language-nb"_s);
        QTest::qWait(0); // another window
        for (const MapPanelState& state : w.map().panels().states())
            QVERIFY(state.isHidden);
        QVERIFY(!w.action(u"legendPanelAction"_s).isChecked());
        w.trigger(u"view/language-en"_s);
        QTest::qWait(0);
        w.trigger(u"legendPanelAction"_s);
        QVERIFY(!stateOf(w, MapPanel::Legend).isHidden);
        QVERIFY(stateOf(w, MapPanel::Title).isHidden);
    }
};

QTEST_MAIN(TestMainWindowPanels)
#include "tst_main_window_panels.moc"

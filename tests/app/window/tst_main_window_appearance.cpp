#include "app/settings/run_settings.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/widget_names.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/language.h"
#include "widgets/theme/theme.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>
#include <utility>

using namespace berg;
using namespace Qt::StringLiterals;
using test::nameOf;
using test::visibleWidgets;
using test::WindowFixture;

namespace {

/** Texts of menus, docks and labels that do not depend on numbers. */
QStringList fixedTexts(const MainWindow& window)
{
    QStringList texts;
    for (const QAction* action : window.findChildren<QAction*>())
        if (!action->objectName().isEmpty() && !action->objectName().startsWith(u"view/language"_s))
            texts << action->text();
    for (const QAction* menu : window.menuBar()->actions())
        texts << menu->text();
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        texts << dock->windowTitle();
    for (const CaptionLabel* label : window.findChildren<CaptionLabel*>())
        if (label->objectName() != u"policyForecast"_s) // a number, and it comes when it is there
            texts << label->text();
    return texts;
}

/** The texts once they stand still: charts are drawn a moment after the picture, in turns. */
QStringList settledTexts(WindowFixture& w)
{
    QStringList texts;
    const bool isSettled = w.until([&] {
        QTest::qWait(150);
        return std::exchange(texts, fixedTexts(w.window())) == fixedTexts(w.window());
    });
    return isSettled ? texts : QStringList();
}

/** First difference of colours between the widgets of two windows of one make. */
QString paletteDifference(const QWidget& a, const QWidget& b)
{
    const QList<QWidget*> left = visibleWidgets(a);
    const QList<QWidget*> right = visibleWidgets(b);
    if (left.size() != right.size())
        return u"%1 and %2 widgets"_s.arg(left.size()).arg(right.size());
    for (qsizetype i = 0; i < left.size(); ++i)
        for (int role = 0; role < QPalette::NColorRoles; ++role)
            for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
                if (left[i]->palette().color(group, static_cast<QPalette::ColorRole>(role)) !=
                    right[i]->palette().color(group, static_cast<QPalette::ColorRole>(role)))
                    return nameOf(*left[i]) +
                           u" role %1: %2, not %3"_s.arg(role).arg(
                               left[i]
                                   ->palette()
                                   .color(group, static_cast<QPalette::ColorRole>(role))
                                   .name(),
                               right[i]
                                   ->palette()
                                   .color(group, static_cast<QPalette::ColorRole>(role))
                                   .name());
    return {};
}

} // namespace

/** Language, appearance and sizes of the window. */
class TestMainWindowAppearance : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        test::failOnWarnings();
        installLanguage(u"en"_s); // others choose another one
    }

    void fullScreenIsReported()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.window().setWindowState(Qt::WindowFullScreen); // by the desktop
        QTRY_VERIFY(w.action(u"fullScreenAction"_s).isChecked());
        w.trigger(u"view/language-da"_s);
        QTest::qWait(0); // another window
        QCOMPARE(w.action(u"fullScreenAction"_s).isChecked(), w.window().isFullScreen());
        w.trigger(u"view/language-en"_s);
        QTest::qWait(0);
        QCOMPARE(w.action(u"fullScreenAction"_s).isChecked(), w.window().isFullScreen());
        w.window().setWindowState(Qt::WindowMaximized | Qt::WindowFullScreen);
        w.trigger(u"fullScreenAction"_s);
        QVERIFY(w.window().isMaximized() && !w.window().isFullScreen());
    }

    /** The swept area is shown from the start, can be switched off, and stays so. */
    void sweptAreaIsSwitchedAndRemembered()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QAction& swept = w.action(u"sweptAction"_s);
        QVERIFY(swept.isCheckable() && swept.isChecked());
        w.workspace.runner().stepBy(60);
        QVERIFY(w.until([&] { return w.record().now.time_s > 59; }));
        const QImage shown = w.map().grab().toImage();
        swept.trigger();
        const QImage hidden = w.map().grab().toImage();
        QVERIFY(hidden != shown);
        QCOMPARE(test::child<QSlider>(w.window(), u"sweptLayer"_s).value(), 0);
        {
            const MainWindow next(w.workspace, w.interaction, w.settings);
            QVERIFY(!test::child<QAction>(next, u"sweptAction"_s).isChecked());
        }
        test::child<QSlider>(w.window(), u"sweptLayer"_s).setValue(50);
        QVERIFY(swept.isChecked());
        QVERIFY(w.map().grab().toImage() != hidden);
        w.settings.setValue("view/swept", false); // of former versions
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(!next.mapView().layers().shows(MapLayer::Swept));
        QVERIFY(!w.settings.contains("view/swept"));
    }

    void layersAreSaved()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& rings = test::child<QSlider>(w.window(), u"ringsLayer"_s);
        const QImage before = w.map().grab().toImage();
        rings.setValue(0);
        QVERIFY(w.map().grab().toImage() != before);
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QCOMPARE(next.mapView().layers().opacity(MapLayer::Rings), 0.0);
        QCOMPARE(test::child<QSlider>(next, u"ringsLayer"_s).value(), 0);
        rings.setValue(100);
        QTRY_VERIFY(w.map().grab().toImage() == before);
    }

    /** The first start is of the layout that plans; the map has most of the window. */
    void firstStartPlans()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.window().parts().docks.begin(Layout::Plan);
        QVERIFY(w.action(u"planLayoutAction"_s).isChecked());
        const auto share = [&] {
            return double(w.map().width()) * w.map().height() /
                   (double(w.window().width()) * w.window().height());
        };
        QTRY_VERIFY2(share() >= 0.6, QByteArray::number(share()));
        w.trigger(u"analyseLayoutAction"_s);
        QTRY_VERIFY(test::child<QDockWidget>(w.window(), u"zetaDock"_s).isVisible());
    }

    /** Each for one kind of work, and as it was left. */
    void layoutsGiveTheMapRoom()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto isShown = [&](const QString& name) {
            return test::child<QDockWidget>(w.window(), name).isVisible();
        };
        const auto share = [&] {
            return double(w.map().width()) * w.map().height() /
                   (double(w.window().width()) * w.window().height());
        };
        QTest::keyClick(&w.map(), Qt::Key_1, Qt::ControlModifier);
        QTRY_VERIFY2(share() >= 0.6, QByteArray::number(share()));
        QVERIFY(isShown(u"tradeoffDock"_s) && !isShown(u"zetaDock"_s));
        QTest::keyClick(&w.map(), Qt::Key_2, Qt::ControlModifier);
        QTRY_VERIFY2(share() >= 0.6, QByteArray::number(share()));
        QVERIFY(!isShown(u"tradeoffDock"_s));
        for (const QString& seen : {u"planDock"_s, u"zetaDock"_s}) // one below the other
            QVERIFY(!test::child<QDockWidget>(w.window(), seen).visibleRegion().isEmpty());
        QVERIFY(w.action(u"flyLayoutAction"_s).isChecked());
        QVERIFY(!w.action(u"planLayoutAction"_s).isChecked());
        test::child<QDockWidget>(w.window(), u"eventsDock"_s).hide();
        QTest::keyClick(&w.map(), Qt::Key_3, Qt::ControlModifier);
        QTRY_VERIFY(isShown(u"zetaDock"_s) && isShown(u"tradeoffDock"_s));
        QTest::keyClick(&w.map(), Qt::Key_2, Qt::ControlModifier);
        QTRY_VERIFY(!isShown(u"tradeoffDock"_s));
        QVERIFY(!isShown(u"eventsDock"_s)); // as it was left
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(test::child<QAction>(next, u"flyLayoutAction"_s).isChecked());
        w.trigger(u"resetLayoutAction"_s);
        QTRY_VERIFY(isShown(u"planDock"_s));
        QVERIFY(!isShown(u"tradeoffDock"_s));
    }

    /** True positions are shown beside estimates, can be hidden, and stay so. */
    void truthIsSwitchedAndRemembered()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.sigma0_m2 = 40000; // apart by some hundred metres
        WindowFixture w(scenario);
        QAction& truth = w.action(u"truthAction"_s);
        QVERIFY(truth.isCheckable() && truth.isChecked());
        w.workspace.runner().stepBy(1);
        QVERIFY(w.until(RunPhase::Paused));
        const QImage shown = w.map().grab().toImage();
        truth.trigger();
        QVERIFY(w.map().grab().toImage() != shown);
        QCOMPARE(w.settings.value("view/truth").toBool(), false);
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(!test::child<QAction>(next, u"truthAction"_s).isChecked());
    }

    void languageChangesAndComesBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-2"});
        w.trigger(u"icebergTool"_s);
        w.click(w.pixelOf(Point(2500, 2000)));
        QVERIFY(w.untilReady());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        const Scenario scenario = w.scenario();
        const auto ids = w.workspace.selection().ids();
        const std::uint64_t flight = w.record().now.generation;
        const QStringList english = settledTexts(w);
        QVERIFY(english.contains(u"Zeta"_s));
        const QSize size = w.window().size();

        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        const QStringList norwegian = settledTexts(w);
        QVERIFY(norwegian.contains(u"Zeta-kurve"_s));
        QCOMPARE(norwegian.size(), english.size());
        qsizetype same = 0;
        for (qsizetype i = 0; i < english.size(); ++i)
            same += norwegian[i] == english[i] ? 1 : 0;
        QVERIFY2(same < english.size() / 2, QByteArray::number(same).constData());

        for (const QString& language : {u"en"_s, u"nb"_s, u"en"_s}) {
            const QPointer<MainWindow> last(&w.window()); // addresses come back, guards do not
            w.trigger(u"view/language-"_s + language);
            QVERIFY(w.until([&] { return last.isNull() || language == u"nb"_s; }));
        }
        QVERIFY(w.until([&] { return fixedTexts(w.window()) == english; }));
        QVERIFY(w.scenario() == scenario);
        QCOMPARE(w.workspace.selection().ids(), ids);
        QCOMPARE(w.record().now.generation, flight);
        QVERIFY(w.workspace.inFlight());
        QVERIFY(!w.action(u"uavTool"_s).isEnabled());
        QVERIFY(w.window().isVisible());
        QCOMPARE(w.window().size(), size);
        QVERIFY(w.action(u"view/language-en"_s).isChecked());
        QCOMPARE(w.document().undoStack()->count(), 1);
    }

    /** Settings made in the window are in force in the next one as well. */
    void languageKeepsViewAndRate()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.map().camera().zoomBy(2, {100, 100});
        const double scale_pxpm = w.map().view().scale_pxpm();
        QTest::keyClick(&w.map(), Qt::Key_BracketRight);
        const double rate =
            test::child<QComboBox>(w.window(), u"rateCombo"_s).currentData().toDouble();
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        QCOMPARE(test::child<QComboBox>(w.window(), u"rateCombo"_s).currentData().toDouble(), rate);
        QCOMPARE(w.map().view().scale_pxpm(), scale_pxpm);
    }

    void themeLeavesNothingBehind_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light to dark") << u"1"_s << u"2"_s << true;
        QTest::newRow("dark to light") << u"2"_s << u"1"_s << false;
    }

    /** A window whose appearance was changed looks like one that came up with it. */
    void themeLeavesNothingBehind()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(bool, isDark);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-2"});
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        const Scenario scenario = w.scenario();
        w.trigger(u"view/appearance-"_s + from);
        QVERIFY(w.action(u"view/appearance-"_s + from).isChecked());
        QTest::qWait(50); // drawn
        w.trigger(u"view/appearance-"_s + to);

        MainWindow fresh(w.workspace, w.interaction, w.settings);
        fresh.resize(w.window().size());
        fresh.show();
        w.window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&w.window()));
        QTRY_VERIFY2(paletteDifference(w.window(), fresh).isEmpty(), // once charts have settled
                     qPrintable(paletteDifference(w.window(), fresh)));
        for (const QWidget* widget : visibleWidgets(w.window())) {
            const QColor window = widget->palette().color(QPalette::Window);
            QVERIFY2((relativeLuminance(window) < 0.2) == isDark, qPrintable(nameOf(*widget)));
        }
        QVERIFY(w.scenario() == scenario);
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{"berg-2"});
        QVERIFY(w.workspace.inFlight());
    }

    /** The tool bar is too narrow for all actions. */
    void toolBarsMoreIsInTheInkOfTheTheme()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto& more = test::child<QToolButton>(w.window(), u"qt_toolbar_ext_button"_s);
        const auto ink = [&more] {
            const QImage image = more.icon().pixmap(48, 48).toImage();
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (const QColor colour = image.pixelColor(x, y); colour.alpha() == 255)
                        return colour.rgb();
            return QRgb{};
        };
        w.trigger(u"view/appearance-2"_s);
        QTRY_COMPARE(ink(), Theme::dark().text.rgb());
        w.trigger(u"view/appearance-1"_s);
        QTRY_COMPARE(ink(), Theme::light().text.rgb());
    }

    void appearanceIsChosenAndSaved()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.action(u"view/appearance-0"_s).isChecked()); // like the system, at first
        w.trigger(u"view/appearance-2"_s);
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(next.findChild<QAction*>(u"view/appearance-2"_s)->isChecked());
        QVERIFY(relativeLuminance(next.palette().color(QPalette::Window)) < 0.2);
        w.trigger(u"view/appearance-1"_s);
    }

    void highContrastIsChosen_data()
    {
        QTest::addColumn<int>("appearance");
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << 3 << false;
        QTest::newRow("dark") << 4 << true;
    }

    void highContrastIsChosen()
    {
        QFETCH(int, appearance);
        QFETCH(bool, isDark);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"view/appearance-%1"_s.arg(appearance));
        QTRY_COMPARE(w.window().palette().color(QPalette::Text), isDark ? Qt::white : Qt::black);
        QCOMPARE(w.window().palette().color(QPalette::Base), isDark ? Qt::black : Qt::white);
        w.trigger(u"view/appearance-1"_s);
    }

    /** All of the window in flight: map, panels, charts, menus; text with smooth edges too. */
    void nightIsRed()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"view/appearance-5"_s);
        QTRY_COMPARE(w.window().palette().color(QPalette::Base), Qt::black);
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.record().now.time_s > 4; }));
        const auto others = [&w] {
            const QImage image = w.window().grab().toImage().convertToFormat(QImage::Format_RGB32);
            QStringList found;
            for (int y = 0; y < image.height() && found.size() < 5; ++y)
                for (int x = 0; x < image.width() && found.size() < 5; ++x)
                    if (const QColor at = image.pixelColor(x, y); // grey is no red either
                        4 * std::max(at.green(), at.blue()) > 3 * at.red() + 32)
                        found << u"%1 at %2, %3"_s.arg(at.name()).arg(x).arg(y);
            return found;
        };
        QTRY_VERIFY2(others().isEmpty(), qPrintable(others().join(u", "_s)));
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(next.findChild<QAction*>(u"view/appearance-5"_s)->isChecked());
        w.trigger(u"view/appearance-1"_s);
    }

    /** The chosen text size is stored and used at the next start. */
    void textSizeIsChosenAndSaved()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.action(u"view/scale-100"_s).isChecked());
        w.trigger(u"view/scale-150"_s);
        w.settings.sync();
        QCOMPARE(RunSettings::savedScale_percent(w.settings.fileName()), 150);
        QVERIFY(w.window().statusBar()->currentMessage().contains(u"Restart Bergwatch"_s));
        w.settings.setValue(kScaleKey, 5000); // no file makes a window of which nothing is seen
        w.settings.sync();
        QCOMPARE(RunSettings::savedScale_percent(w.settings.fileName()), 200);
        QCOMPARE(RunSettings::savedScale_percent(w.file(u"none.ini"_s)), 100);
    }

    /** The status bar forgets; another language, which makes another window, does not. */
    void messagesAreKept()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto* list = &test::child<QListWidget>(w.window(), u"messageList"_s);
        QCOMPARE(list->count(), 0);
        w.trigger(u"recoverAction"_s);
        w.trigger(u"copyPictureAction"_s); // takes the place of the first one in the status bar
        QCOMPARE(list->count(), 2);
        QVERIFY(list->item(0)->text().endsWith(u"There is no unsaved work to recover"_s));
        QVERIFY(list->item(1)->text().endsWith(u"Picture of the map copied"_s));
        const QString first = list->item(0)->text();
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-en"_s);
        QTRY_VERIFY(&w.window() != before);
        list = &test::child<QListWidget>(w.window(), u"messageList"_s);
        QCOMPARE(list->count(), 2);
        QCOMPARE(list->item(0)->text(), first);
        list->selectAll();
        QTest::keyClick(list, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text().count(u'\n'), 1);
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(first));
    }

    void overviewIsShownOnDemandAndMovesTheMap()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.untilReady());
        auto& overview = test::child<OverviewInset>(w.window(), u"overviewInset"_s);
        QVERIFY(!overview.isVisible());
        w.trigger(u"overviewAction"_s);
        QVERIFY(overview.isVisible());
        QVERIFY(w.settings.value(u"view/overview"_s).toBool());
        const LocalFrame frame(w.scenario().origin);
        const LatLon place = frame.toGeographic({-300'000, 200'000});
        const QPoint at = overview.pixelOf(place).toPoint();
        QTest::mouseClick(&overview, Qt::LeftButton, {}, at);
        const Point middle_m = w.map().toWorld(QRectF(w.map().rect()).center());
        const LatLon picked = *overview.placeAt(at);
        QVERIFY((middle_m - frame.toPlane(picked)).norm() < 1);
        w.trigger(u"overviewAction"_s);
        QVERIFY(!overview.isVisible());
    }

    void layoutComesBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const QSize map = w.map().size();
        auto* plan = w.window().findChild<QDockWidget*>(u"planDock"_s);
        auto* zeta = w.window().findChild<QDockWidget*>(u"zetaDock"_s);
        plan->close();
        w.window().addDockWidget(Qt::LeftDockWidgetArea, zeta);
        w.trigger(u"resetLayoutAction"_s);
        QVERIFY(plan->isVisible());
        QCOMPARE(w.window().dockWidgetArea(zeta), Qt::BottomDockWidgetArea);
        QVERIFY(w.until([&] { return w.map().size() == map; }));
    }
};

QTEST_MAIN(TestMainWindowAppearance)
#include "tst_main_window_appearance.moc"

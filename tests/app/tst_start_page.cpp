#include "app/files/start_page_controller.h"
#include "app/start/start_items.h"
#include "app/start/start_page.h"
#include "app/start/tour.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/language.h"

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <atomic>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario three(std::int64_t seed = 31)
{
    return randomScenario(seed, {.icebergs = 3});
}

/** The window as the program opens it without a file. */
struct StartWindow : WindowFixture
{
    StartWindow() : WindowFixture(three()) { window().parts().start.showPage(); }
    [[nodiscard]] StartPage* page() { return window().findChild<StartPage*>(); }
    [[nodiscard]] bool isShown() { return window().parts().start.pageIsShown(); }
    [[nodiscard]] Tour* tour() { return window().findChild<Tour*>(); }
    [[nodiscard]] QList<RecentRow*> rows() { return page()->findChildren<RecentRow*>(); }
    /** The key where the focus is. */
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
};

} // namespace

class TestStartPage : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void coversTheWindowBelowTheMenus()
    {
        StartWindow w;
        const StartPage& page = *w.page();
        QVERIFY(page.isVisible());
        QCOMPARE(page.width(), w.window().width());
        QCOMPARE(page.geometry().bottom(), w.window().rect().bottom());
        QVERIFY(page.y() > 0);
        w.window().resize(1500, 900);
        QVERIFY(w.until([&] { return page.width() == w.window().width(); }));
        w.trigger(u"startPageAction"_s); // there is one already
        QCOMPARE(w.window().findChildren<StartPage*>().size(), 1);
    }

    void commandsHaveRoomForTheirTexts_data()
    {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "nb", "da", "fr"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }

    void commandsHaveRoomForTheirTexts()
    {
        QFETCH(QString, language);
        installLanguage(language);
        const auto back = qScopeGuard([] { installLanguage(u"en"_s); });
        QWidget window;
        window.resize(1200, 800);
        StartPage page(u"a scenario"_s, true, true, &window);
        page.setTheme(Theme::light());
        page.setTop(0);
        window.show();
        for (const QPushButton* button : page.findChildren<QPushButton*>())
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
    }

    void goesOnWithWhatIsBelow_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Return") << int{Qt::Key_Return};
        QTest::newRow("Space") << int{Qt::Key_Space};
        QTest::newRow("Esc") << int{Qt::Key_Escape};
    }
    void goesOnWithWhatIsBelow()
    {
        QFETCH(int, key);
        StartWindow w;
        w.settings.setValue("start/tourSeen", true);
        StartWindow::press(static_cast<Qt::Key>(key));
        QVERIFY(!w.isShown());
        QVERIFY(w.scenario() == three());
        QVERIFY(!w.workspace.inFlight());
        QCOMPARE(QApplication::focusWidget(), &w.map());
        w.trigger(u"startPageAction"_s);
        QVERIFY(w.isShown());
    }

    /** The file has the same name as the initial example. */
    void goesOnWithTheLastFile_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Return") << int{Qt::Key_Return};
        QTest::newRow("Esc") << int{Qt::Key_Escape};
    }
    void goesOnWithTheLastFile()
    {
        QFETCH(int, key);
        WindowFixture w(defaultScenario());
        Scenario mine = defaultScenario();
        mine.icebergs.pop_back();
        const QString path = w.file(u"mine.berg"_s);
        saveScenario(mine, path.toStdString());
        w.settings.setValue("files/recent", QStringList{w.file(u"gone.berg"_s), path});
        w.settings.setValue("start/tourSeen", true);
        w.window().parts().start.showPage();
        QCOMPARE(test::child<QPushButton>(w.window(), u"continueButton"_s).text(),
                 u"Continue with mine.berg"_s);
        StartWindow::press(static_cast<Qt::Key>(key));
        QVERIFY(!w.window().parts().start.pageIsShown());
        QVERIFY(w.scenario() == (key == Qt::Key_Return ? mine : defaultScenario()));
        QCOMPARE(w.document().filePath(), key == Qt::Key_Return ? path : QString());
        if (key != Qt::Key_Return)
            return;
        w.trigger(u"startPageAction"_s); // now it is what lies below
        StartWindow::press(Qt::Key_Return);
        QVERIFY(w.scenario() == mine);
    }

    void recentFilesAreListed()
    {
        WindowFixture w(three());
        const QString here = w.file(u"here.berg"_s);
        const QString broken = w.file(u"broken.berg"_s);
        const QString gone = w.file(u"gone.berg"_s);
        saveScenario(three(40), here.toStdString());
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        w.settings.setValue("files/recent", QStringList{here, broken, gone});
        w.window().parts().start.showPage();
        auto* page = w.window().findChild<StartPage*>();
        const auto rows = [&] { return page->findChildren<RecentRow*>(); };
        QVERIFY(w.until([&] { return rows().size() == 3; }));
        QCOMPARE(rows()[0]->text(), u"here.berg"_s);
        QVERIFY(rows()[0]->accessibleDescription().contains(u"3 iceberg"_s));
        QVERIFY(rows()[0]->accessibleDescription().contains(QDir::toNativeSeparators(
            QFileInfo(here).absolutePath()))); // two files of one name are distinguished
        QVERIFY(!rows()[1]->accessibleDescription().contains(u"iceberg"_s));
        QVERIFY(rows()[2]->accessibleDescription().contains(u"gone"_s));

        rows()[2]->click(); // nothing to open
        QVERIFY(w.window().parts().start.pageIsShown());
        test::child<QToolButton>(*rows()[2], u"removeRecentButton"_s).click();
        QVERIFY(w.until([&] { return rows().size() == 2; }));
        QCOMPARE(w.settings.value("files/recent").toStringList(), QStringList({here, broken}));

        rows()[1]->click(); // says what is wrong and stays
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(w.window().parts().start.pageIsShown());
        rows()[0]->click();
        QVERIFY(!w.window().parts().start.pageIsShown());
        QVERIFY(w.scenario() == three(40));
        QCOMPARE(w.document().filePath(), here);
    }

    void examplesAreAllThereAndOpen_data()
    {
        QTest::addColumn<QString>("path");
        for (const QString& path : examplePaths())
            QTest::newRow(qPrintable(path.section(u'/', -1))) << path;
    }
    void examplesAreAllThereAndOpen()
    {
        QFETCH(QString, path);
        StartWindow w;
        const QString name = path.section(u'/', -1);
        auto& card = test::child<ExampleCard>(*w.page(), u"example "_s + name);
        QVERIFY(w.until([&] { return !card.text().isEmpty(); }));
        card.click();
        QVERIFY(!w.isShown());
        const QString shipped = QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios/") + name;
        QVERIFY(w.scenario() == loadScenario(shipped.toStdString()));
        QCOMPARE(card.text().toStdString(), w.scenario().name);
        QVERIFY(w.document().filePath().isEmpty()); // an example is not overwritten
        QVERIFY(w.document().isClean());
    }

    void everyShippedScenarioIsAnExample()
    {
        const QStringList shipped =
            QDir(QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios")).entryList({u"*.berg"_s});
        std::set<QString> listed;
        for (const QString& path : examplePaths())
            listed.insert(path.section(u'/', -1));
        QCOMPARE(listed, std::set<QString>(shipped.begin(), shipped.end()));
    }

    /** Painted off this thread (the fixture forbids planning on it), again for each appearance. */
    void examplePicturesFollowTheAppearance()
    {
        StartContent content;
        std::map<bool, std::vector<QImage>> images;
        connect(&content, &StartContent::examplePainted, this,
                [&](int, const Example& example, const QColor& sea) {
                    images[sea == Theme::dark().sea].push_back(example.image);
                });
        const NoBlockingScope guard;
        const auto count = static_cast<std::size_t>(examplePaths().size());
        content.paintExamples(Theme::light(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(images[false].size() == count, 60000);
        content.paintExamples(Theme::light(), 1); // not wanted any more
        content.paintExamples(Theme::dark(), 2);
        QTRY_VERIFY_WITH_TIMEOUT(images[true].size() == count, 60000);
        QVERIFY(images[false].size() < 2 * count);
        QCOMPARE(images[false][0].size(), kExampleImage_px);
        QCOMPARE(images[true][0].size(), kExampleImage_px * 2);
        QCOMPARE(images[false][0].pixelColor(3, 3), Theme::light().sea);
        for (std::size_t i = 1; i < count; ++i)
            QVERIFY(images[false][i] != images[false][i - 1]);
    }

    /** Neither the list of recent files nor the end of the page waits for a plan. */
    void longPlanHoldsNothingUp()
    {
        const QTemporaryDir folder;
        Scenario hard = randomScenario(5, {.icebergs = 120});
        hard.planner.backend = Backend::Exact;
        const QString path = folder.filePath(u"hard.berg"_s);
        saveScenario(hard, path.toStdString());
        auto content = std::make_unique<StartContent>();
        std::atomic<int> painted{0};
        connect(
            content.get(), &StartContent::examplePainted, this, [&] { ++painted; },
            Qt::DirectConnection);
        QList<RecentFile> recent;
        connect(content.get(), &StartContent::recentRead, this,
                [&](const QList<RecentFile>& files) { recent = files; });
        content->paintExamples(Theme::light(), 1, {path, path});
        content->readRecent({path}, Theme::light(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(recent.size(), 1, 60000);
        QCOMPARE(recent.front().icebergs.value_or(0), 120);
        QCOMPARE(recent.front().image.size(), kRecentImage_px);
        content.reset();
        QCOMPARE(painted.load(), 0); // stopped: a image without its plan is not shown
    }

    /** Even in a small image, 40 icebergs are distinguishable. */
    void recentPicturesAreOfDots()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"many.berg"_s);
        saveScenario(randomScenario(5, {.icebergs = 40}), path.toStdString());
        StartContent content;
        QList<RecentFile> recent;
        connect(&content, &StartContent::recentRead, this,
                [&](const QList<RecentFile>& files) { recent = files; });
        content.readRecent({path}, Theme::dark(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(recent.size(), 1, 60000);
        const QImage& image = recent.front().image;
        int sea = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                sea += image.pixelColor(x, y) == Theme::dark().sea ? 1 : 0;
        QVERIFY2(sea > 0.65 * image.width() * image.height(), qPrintable(QString::number(sea)));
    }

    /** A run has the image of its scenario. */
    void runsHavePictures()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"flown.bergrun"_s);
        Scenario scenario = three();
        scenario.duration_s = 30;
        Mission mission(scenario);
        mission.advance(scenario.duration_s);
        saveRun(runOf(mission), path.toStdString());
        StartContent content;
        QList<RecentFile> recent;
        connect(&content, &StartContent::recentRead, this,
                [&](const QList<RecentFile>& files) { recent = files; });
        content.readRecent({path}, Theme::light(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(recent.size(), 1, 60000);
        QCOMPARE(recent.front().icebergs.value_or(0), int(scenario.icebergs.size()));
        QCOMPARE(recent.front().image.size(), kRecentImage_px);
    }

    void opensAndBegins()
    {
        StartWindow w;
        test::child<QPushButton>(*w.page(), u"startOpenButton"_s).click(); // and cancels
        QVERIFY(w.isShown());
        QCOMPARE(w.interaction.openQuestions, 1);
        test::child<QPushButton>(*w.page(), u"startNewButton"_s).click();
        QVERIFY(!w.isShown());
        QVERIFY(w.scenario().icebergs.empty());
    }

    void asksBeforeItReplacesUnsavedWork()
    {
        WindowFixture w(three());
        w.dragTau(0.5, 0.8);
        const Scenario changed = w.scenario();
        w.trigger(u"startPageAction"_s);
        auto* page = w.window().findChild<StartPage*>();
        page->findChild<ExampleCard*>()->click();
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QVERIFY(w.scenario() == changed);
        QVERIFY(w.window().parts().start.pageIsShown());
    }

    /** By Tab everything is reached, in a circle, and nothing that lies below. */
    void keyboardGoesRoundOnThePage()
    {
        StartWindow w;
        std::set<QWidget*> reached;
        QWidget* const first = QApplication::focusWidget();
        do {
            reached.insert(QApplication::focusWidget());
            StartWindow::press(Qt::Key_Tab);
            QVERIFY(w.page()->isAncestorOf(QApplication::focusWidget()));
        } while (QApplication::focusWidget() != first && reached.size() < 100);
        QCOMPARE(QApplication::focusWidget(), first);
        for (const ExampleCard* card : w.page()->findChildren<ExampleCard*>())
            QVERIFY(reached.count(const_cast<ExampleCard*>(card)) == 1);
        for (const QPushButton* button : w.page()->findChildren<QPushButton*>())
            QVERIFY(reached.count(const_cast<QPushButton*>(button)) == 1);
    }

    /** Keys of the tools and the flight rest while one cannot see what they do. */
    void keysOfTheMapRest()
    {
        StartWindow w;
        for (const Qt::Key key : {Qt::Key_I, Qt::Key_U, Qt::Key_Period, Qt::Key_Delete})
            StartWindow::press(key);
        QVERIFY(w.isShown());
        QCOMPARE(w.map().tools().kind(), MapToolKind::Select);
        QVERIFY(!w.workspace.inFlight());
        QVERIFY(w.scenario() == three());
    }

    void isShownAtTheStartUnlessUnwanted()
    {
        StartWindow w;
        QVERIFY(StartPageController::wantsStartPage(w.settings));
        auto& box = test::child<QCheckBox>(*w.page(), u"showAtStartBox"_s);
        QVERIFY(box.isChecked());
        box.click();
        QVERIFY(!StartPageController::wantsStartPage(w.settings));
        QVERIFY(w.isShown()); // for this time
    }

    void stillThereInAnotherLanguage()
    {
        StartWindow w;
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        QVERIFY(w.isShown());
        w.trigger(u"view/language-en"_s);
        QTest::qWait(0);
    }

    void tourComesOnceByItself()
    {
        StartWindow w;
        StartWindow::press(Qt::Key_Return);
        QVERIFY(w.tour() != nullptr);
        StartWindow::press(Qt::Key_Escape);
        QVERIFY(w.until([&] { return w.tour() == nullptr; }));
        w.trigger(u"startPageAction"_s);
        StartWindow::press(Qt::Key_Return);
        QVERIFY(!w.isShown());
        QVERIFY(w.tour() == nullptr);
        w.trigger(u"tourAction"_s); // but whenever one likes
        QVERIFY(w.tour() != nullptr);
    }

    void tourHasThreeStepsThereAndBack()
    {
        WindowFixture w(three());
        w.trigger(u"tourAction"_s);
        auto* tour = w.window().findChild<Tour*>();
        QVERIFY(tour != nullptr);
        const auto& title = test::child<QLabel>(*tour, u"tourTitle"_s);
        QStringList titles{title.text()};
        StartWindow::press(Qt::Key_Return);
        titles << title.text();
        StartWindow::press(Qt::Key_Left);
        QCOMPARE(title.text(), titles[0]);
        StartWindow::press(Qt::Key_Right);
        StartWindow::press(Qt::Key_Space);
        QCOMPARE(tour->step(), 2U);
        titles << title.text();
        titles.removeDuplicates();
        QCOMPARE(titles.size(), 3);
        QVERIFY(!w.workspace.inFlight()); // Space pressed the button
        StartWindow::press(Qt::Key_Return);
        QVERIFY(w.until([&] { return w.window().findChild<Tour*>() == nullptr; }));
        QCOMPARE(QApplication::focusWidget(), &w.map());
    }

    /** "Press Space", says the last step. */
    void spaceFliesWhereTheTourSaysSo()
    {
        WindowFixture w(three());
        w.trigger(u"tourAction"_s);
        StartWindow::press(Qt::Key_Right);
        StartWindow::press(Qt::Key_Right);
        StartWindow::press(Qt::Key_Space);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QVERIFY(w.until([&] { return w.window().findChild<Tour*>() == nullptr; }));
    }
};

QTEST_MAIN(TestStartPage)
#include "tst_start_page.moc"

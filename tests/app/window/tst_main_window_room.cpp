#include "tests/support/window/map_fixture.h"
#include "tests/support/window/widget_names.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/language.h"

#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QScreen>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::nameOf;
using test::visibleWidgets;
using test::WindowFixture;

namespace {

/** Returns the text that does not fit into this widget; empty if all fits. */
QString clippedText(const QWidget& widget)
{
    if (qobject_cast<const FigureLabel*>(&widget) != nullptr)
        return {}; // gets smaller by itself
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->text().isEmpty())
            return {};
        const QRect room = label->contentsRect();
        const int flags = label->wordWrap() ? int{Qt::TextWordWrap} : 0;
        QTextDocument shown; // links are not as long as their tags
        shown.setHtml(label->text());
        const QString text =
            Qt::mightBeRichText(label->text()) ? shown.toPlainText() : label->text();
        const QSize needed = label->fontMetrics().boundingRect(room, flags, text).size();
        const bool fits = needed.width() <= room.width() && needed.height() <= room.height();
        return fits ? QString()
                    : u"%1 (%2 x %3 in %4 x %5)"_s.arg(label->text())
                          .arg(needed.width())
                          .arg(needed.height())
                          .arg(room.width())
                          .arg(room.height());
    }
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    if (button != nullptr && !button->text().isEmpty())
        return button->sizeHint().width() > button->width() ? button->text() + u" (button)"_s
                                                            : QString();
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        for (int i = 0; i < tabs->count(); ++i)
            if (!tabs->rect().contains(tabs->tabRect(i)) ||
                tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)) > tabs->tabRect(i).width())
                return tabs->tabText(i) + u" (tab)"_s;
    return {};
}

/** All widgets whose text is cut. */
QStringList clipped(const QWidget& window)
{
    QStringList faults;
    for (const QWidget* widget : visibleWidgets(window))
        if (const QString text = clippedText(*widget); !text.isEmpty())
            faults << u"\"%1\": %2"_s.arg(text, nameOf(*widget));
    return faults;
}

} // namespace

/** The window has room for what it says, in every language, on every screen. */
class TestMainWindowRoom : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        test::failOnWarnings();
        installLanguage(u"en"_s); // others choose another one
    }

    /** The window is scaled to twice its size. */
    void panelsShareAPlaceOnALowScreen()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& tradeoff = test::child<QDockWidget>(w.window(), u"tradeoffDock"_s);
        auto* plan = &test::child<QDockWidget>(w.window(), u"planDock"_s);
        QVERIFY(!w.window().tabifiedDockWidgets(&tradeoff).contains(plan));
        tradeoff.setMinimumHeight(w.window().screen()->availableSize().height() - 150);
        w.trigger(u"resetLayoutAction"_s);
        QVERIFY(w.window().tabifiedDockWidgets(&tradeoff).contains(plan));
        QTRY_VERIFY(!tradeoff.visibleRegion().isEmpty());
    }

    /** The plan has the rest, whatever the size; what is squeezed stays inside its dock. */
    void tradeoffIsAsHighAsItsContent()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& dock = test::child<QDockWidget>(w.window(), u"tradeoffDock"_s);
        QWidget& tradeoff = *dock.widget();
        const auto fits = [&] {
            return tradeoff.height() == tradeoff.layout()->totalHeightForWidth(tradeoff.width()) &&
                   dock.rect().contains(tradeoff.geometry());
        };
        QTRY_VERIFY(fits());
        w.window().resize(1600, 1200);
        QTRY_VERIFY(fits());
        test::child<QToolButton>(tradeoff, u"planDetails"_s).click();
        QTRY_VERIFY(fits());
        test::child<QToolButton>(tradeoff, u"planDetails"_s).click();
        QTRY_VERIFY(fits());
        w.window().resize(1280, 800);
        QTRY_VERIFY(fits());
        const auto dockOf = [&](const QString& name) {
            return &test::child<QDockWidget>(w.window(), name);
        };
        QDockWidget* icebergs = dockOf(u"icebergsDock"_s);
        for (const QString& name : {u"inspectorDock"_s, u"paretoDock"_s})
            dockOf(name)->hide();
        w.window().addDockWidget(Qt::RightDockWidgetArea, icebergs);
        icebergs->show();
        w.window().splitDockWidget(icebergs, &dock, Qt::Vertical);
        w.window().splitDockWidget(&dock, dockOf(u"planDock"_s), Qt::Vertical);
        QTRY_VERIFY(icebergs->y() < dock.y());
        QTRY_VERIFY(fits());
    }

    /** It takes one line or two as the flight goes. */
    void aLongerStateOfThePlanMovesNothing()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& state = test::child<QLabel>(w.window(), u"planState"_s);
        const auto& below = test::child<QToolButton>(w.window(), u"planDetails"_s);
        const auto place = [&] { return below.mapTo(&w.window(), QPoint()); };
        QTest::qWait(50); // laid out
        const QPoint before = place();
        state.setText(u"Solver limit reached; flying to the nearest iceberg, which is far"_s);
        QTest::qWait(50);
        QVERIFY(state.heightForWidth(state.width()) > QFontMetrics(state.font()).height() * 3 / 2);
        QCOMPARE(place(), before);
    }

    /** However many docks share a place. */
    void namesOnTabsAreWhole_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << u"en"_s;
        QTest::newRow("French") << u"fr"_s;
        QTest::newRow("Norwegian") << u"nb"_s;
    }

    void namesOnTabsAreWhole()
    {
        QFETCH(QString, language);
        installLanguage(language);
        const auto restore = qScopeGuard([] { installLanguage(u"en"_s); });
        WindowFixture w(test::MapFixture::fourIcebergs());
        for (const QString& name : {u"historyDock"_s, u"layersDock"_s})
            test::child<QDockWidget>(w.window(), name).show();
        QTest::qWait(50); // laid out
        int bars = 0;
        for (const auto* tabs :
             w.window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (!tabs->isVisible())
                continue;
            ++bars;
            for (int i = 0; i < tabs->count(); ++i)
                QVERIFY2(tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)) <
                             tabs->tabRect(i).width(),
                         qPrintable(tabs->tabText(i)));
        }
        QVERIFY(bars > 0);
        QCOMPARE(w.window().size(), QSize(1280, 800));
    }

    void fitsTheDesignSize_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("longer"); // percent
        QTest::newRow("Danish") << u"da"_s << 0;
        QTest::newRow("English") << u"en"_s << 0;
        QTest::newRow("French") << u"fr"_s << 0;
        QTest::newRow("Norwegian") << u"nb"_s << 0;
        QTest::newRow("40 % longer") << u"en"_s << 40;
    }

    /** Nothing is cut, neither with a plan, an object in the inspector, nor in flight. */
    void fitsTheDesignSize()
    {
        QFETCH(QString, language);
        QFETCH(int, longer);
        installLanguage(language);
        const auto restore = qScopeGuard([] { installLanguage(u"en"_s); });
        std::unique_ptr<test::LongerTexts> texts;
        if (longer > 0)
            texts = std::make_unique<test::LongerTexts>(longer);
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto check = [&](const char* state) {
            QTest::qWait(50); // laid out
            const QSize least = w.window().minimumSizeHint();
            if (least.width() > 1280 || least.height() > 800)
                return u"%1: at least %2 x %3\n"_s.arg(QString::fromLatin1(state))
                    .arg(least.width())
                    .arg(least.height());
            if (w.window().size() != QSize(1280, 800))
                return u"%1: %2 x %3\n"_s.arg(QString::fromLatin1(state))
                    .arg(w.window().width())
                    .arg(w.window().height());
            const QStringList cut = clipped(w.window());
            return cut.isEmpty() ? QString()
                                 : QString::fromLatin1(state) + u": "_s + cut.join(u'\n') + u'\n';
        };
        QString faults = check("planned");
        w.window().findChild<QDockWidget*>(u"inspectorDock"_s)->raise();
        faults += check("scenario");
        w.workspace.selection().set({"berg-2"});
        faults += check("iceberg");
        w.workspace.selection().set({"uav-1"});
        faults += check("UAV");
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        faults += check("in flight");
        QVERIFY2(faults.isEmpty(), qPrintable(faults));
    }

    /** A long error message neither widens the window nor is cut without an ellipsis. */
    void longErrorFitsTheStatusBar()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        Scenario wrong = w.scenario();
        wrong.name = std::string(150, 'x');
        wrong.uavs[0].spec.airspeed_mps = -1;
        w.document().reset(wrong);
        QVERIFY(w.until(RunPhase::Failed));
        QTest::qWait(50); // laid out
        QCOMPARE(w.window().size(), QSize(1280, 800));
        QVERIFY(w.window().minimumSizeHint().width() <= 1280);
        const QStringList cut = clipped(w.window());
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
    }

    /** Every tool and command of the tool bar is in sight. */
    void toolBarIsWhole_data() { fitsTheDesignSize_data(); }

    void toolBarIsWhole()
    {
        QFETCH(QString, language);
        QFETCH(int, longer);
        installLanguage(language);
        const auto restore = qScopeGuard([] { installLanguage(u"en"_s); });
        std::unique_ptr<test::LongerTexts> texts;
        if (longer > 0)
            texts = std::make_unique<test::LongerTexts>(longer);
        WindowFixture w(test::MapFixture::fourIcebergs());
        for (const QToolButton* button : w.window().findChildren<QToolButton*>())
            if (button->objectName() == u"qt_toolbar_ext_button"_s)
                QVERIFY(!button->isVisible());
    }
};

QTEST_MAIN(TestMainWindowRoom)
#include "tst_main_window_room.moc"

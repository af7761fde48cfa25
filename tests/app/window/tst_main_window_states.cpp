#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/theme/theme.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

void step(WindowFixture& w)
{
    const double before_s = w.record().now.time_s;
    w.workspace.step();
    QVERIFY(w.until([&] { return w.record().now.time_s > before_s + 0.5; }));
    QVERIFY(w.until(RunPhase::Paused));
}

double luminance(const QColor& colour)
{
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/** Returns the contrast of text on its background, by the formula of WCAG. */
double contrastOf(const QWidget& field)
{
    const double text = luminance(field.palette().color(QPalette::Text));
    const double ground = luminance(field.palette().color(QPalette::Base));
    return (std::max(text, ground) + 0.05) / (std::min(text, ground) + 0.05);
}

/** In small letters, without what is only punctuation. */
QString plainWords(QString text)
{
    for (const QChar mark : u"&…:."_s)
        text.remove(mark);
    return text.trimmed().toLower();
}

/** Returns the text on a button or label, or beside a field; empty if it has only a picture. */
QString wordsOn(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return label->text();
    if (const auto* tool = qobject_cast<const QToolButton*>(&widget))
        return tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()
                   ? QString()
                   : tool->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text();
    const bool isField = qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
                         qobject_cast<const QComboBox*>(&widget) != nullptr ||
                         qobject_cast<const QLineEdit*>(&widget) != nullptr;
    return isField ? widget.accessibleName() : QString(); // its label stands beside it
}

} // namespace

/** Temporary states in the window. */
class TestMainWindowStates : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** A tool tip says more than what it is at, or nothing. */
    void noToolTipRepeatsItsLabel()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QStringList repeated;
        for (const QWidget* widget : w.window().findChildren<QWidget*>())
            if (const QString words = plainWords(wordsOn(*widget));
                !words.isEmpty() && plainWords(widget->toolTip()) == words)
                repeated << widget->objectName() + u": "_s + widget->toolTip();
        QVERIFY2(repeated.isEmpty(), qUtf8Printable(repeated.join(u'\n')));
    }

    void lockedFieldsAreReadableInEveryTheme()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QDockWidget& inspector = dock(w, u"inspectorDock"_s);
        inspector.raise();
        step(w);
        for (const char* appearance : {"2", "1", "4", "3", "2", "1"}) {
            w.trigger(u"view/appearance-"_s + QLatin1String(appearance));
            QTest::qWait(0);
            int fields = 0;
            for (const QLineEdit* field : inspector.findChildren<QLineEdit*>()) {
                ++fields;
                QVERIFY2(contrastOf(*field) >= 4.5, qPrintable(field->objectName()));
            }
            for (const QPlainTextEdit* page : inspector.findChildren<QPlainTextEdit*>())
                QVERIFY2(contrastOf(*page) >= 4.5, qPrintable(page->objectName()));
            QVERIFY(fields > 20);
        }
    }

    /** The plan that was is none of a UAV that returns. */
    void aReturningUavHasNoPlan()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        step(w);
        const auto& state = test::child<QLabel>(w.window(), u"planState"_s);
        QVERIFY(!state.text().contains(u"No plan"_s));
        w.trigger(u"returnAction"_s);
        w.workspace.step();
        QVERIFY(w.until([&] { return state.text().contains(u"No plan"_s); }));
        QVERIFY(!state.text().contains(u"optimal"_s));
        QVERIFY(!test::child<QLabel>(w.window(), u"planDistance"_s).text().contains(u'0'));
    }

    /** Looking back it is locked, and says why. */
    void tauIsLockedWhileLookingBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        for (int i = 0; i < 3; ++i)
            step(w);
        auto& slider = test::child<QSlider>(w.window(), u"tauSlider"_s);
        const auto& said = test::child<QLabel>(w.window(), u"policyForecast"_s);
        QVERIFY(slider.isEnabled());
        w.workspace.seek(1);
        QVERIFY(w.until([&] { return !slider.isEnabled(); }));
        QVERIFY(!test::child<QWidget>(w.window(), u"tauField"_s).isEnabled());
        QVERIFY(!test::child<QWidget>(w.window(), u"tauStrip"_s).isEnabled());
        QVERIFY2(said.text().contains(u"looking back"_s), qPrintable(said.text()));
        w.workspace.seekLatest();
        QVERIFY(w.until([&] { return slider.isEnabled(); }));
        QVERIFY(!said.text().contains(u"looking back"_s));
    }

    /** The pointer comes and goes: what is to be clicked beside it stays. */
    void theStatusBarStandsStill()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.uavs.front().spec.endurance_s = 60; // which is warned of
        WindowFixture w(scenario);
        const auto& findings = test::child<QToolButton>(w.window(), u"checksButton"_s);
        QVERIFY(w.until([&] { return findings.isVisible(); }));
        QTest::mouseMove(&w.map(), w.map().rect().center());
        QTRY_VERIFY(!test::child<QLabel>(w.window(), u"cursorLabel"_s).text().isEmpty());
        QTest::qWait(0);
        const QPoint before = findings.mapToGlobal(QPoint());
        QEvent left(QEvent::Leave);
        QCoreApplication::sendEvent(&w.map(), &left);
        QTRY_VERIFY(test::child<QLabel>(w.window(), u"cursorLabel"_s).text().isEmpty());
        QTest::qWait(0);
        QCOMPARE(findings.mapToGlobal(QPoint()), before);
    }

    /** A second alarm lies over the map; its panels make room. */
    void theMapStandsStill()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& alarms = test::child<AlarmStrip>(w.window(), u"alarmStrip"_s);
        QTest::qWait(0);
        const QRect map_px = w.map().geometry();
        const int line_px = alarms.height();
        QVERIFY(map_px.top() >= line_px);
        alarms.showNotices({{.kind = NoticeKind::LateHome, .about = {"uav-1"}, .text = u"One"_s},
                            {.kind = NoticeKind::WindLimit, .about = {"uav-1"}, .text = u"Two"_s}});
        QTRY_VERIFY(alarms.height() > line_px);
        QTest::qWait(0);
        QCOMPARE(w.map().geometry(), map_px);
    }

    /** Notices come into room that is there for them. */
    void theRowsOfTheInspectorStandStill()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"uav-1"});
        dock(w, u"inspectorDock"_s).raise();
        QTest::qWait(0);
        const auto& row = test::child<QWidget>(w.window(), u"uavs.heading_deg"_s);
        const auto& issues = test::child<QLabel>(w.window(), u"inspectorIssues"_s);
        const QWidget& panel = *dock(w, u"inspectorDock"_s).widget();
        const int before_px = row.mapTo(&panel, QPoint()).y();
        w.document().edit(u"Edit"_s,
                          [](Scenario& scenario) { scenario.uavs.front().spec.endurance_s = 60; });
        QTRY_VERIFY(issues.isVisible());
        QTest::qWait(0);
        QCOMPARE(row.mapTo(&panel, QPoint()).y(), before_px);
        QVERIFY(w.untilReady());
        step(w);
        QTRY_VERIFY(test::child<QLabel>(w.window(), u"inspectorLock"_s).isVisible());
        QTest::qWait(0);
        QCOMPARE(row.mapTo(&panel, QPoint()).y(), before_px);
    }

private:
    static QDockWidget& dock(WindowFixture& w, const QString& name)
    {
        return test::child<QDockWidget>(w.window(), name);
    }
};

QTEST_MAIN(TestMainWindowStates)
#include "tst_main_window_states.moc"

#include "tests/support/window/panel_test.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct PlaybackBarFixture
{
    PlaybackBar bar;
    QToolButton& play = test::child<QToolButton>(bar, u"playButton"_s);
    QToolButton& step = test::child<QToolButton>(bar, u"stepButton"_s);
    QToolButton& reset = test::child<QToolButton>(bar, u"resetButton"_s);
    QComboBox& rate = test::child<QComboBox>(bar, u"rateCombo"_s);
    QSignalSpy played{&bar, &PlaybackBar::playRequested};
    QSignalSpy paused{&bar, &PlaybackBar::pauseRequested};
    QSignalSpy stepped{&bar, &PlaybackBar::stepRequested};
    QSignalSpy wasReset{&bar, &PlaybackBar::resetRequested};
    QSignalSpy timeEdited{&bar, &PlaybackBar::timeEdited};
    QSignalSpy rateEdited{&bar, &PlaybackBar::rateEdited};

    PlaybackBarFixture()
    {
        bar.resize(600, bar.sizeHint().height());
        bar.show();
    }
};

/** Returns the icon on a transparent ground, `side_px` high. */
QImage drawn(IconName name, const Theme& theme, int side_px, QIcon::Mode mode = QIcon::Normal)
{
    return icon(name, theme).pixmap(QSize(side_px, side_px), mode).toImage();
}

void addThemes()
{
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

} // namespace

class TestPlaybackBar : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void escapeTakesTheTypedTimeBack()
    {
        PlaybackBarFixture f;
        f.bar.showState(RunPhase::Flying, 83, 600, std::nullopt);
        f.bar.editTime();
        auto& time = test::child<QLineEdit>(f.bar, u"timeField"_s);
        const QString before = time.text();
        QTest::keyClicks(&time, u"3"_s);
        QTest::keyClick(&time, Qt::Key_Escape);
        QVERIFY(f.bar.focusWidget() != &time);
        QCOMPARE(time.text(), before);
        QCOMPARE(f.timeEdited.count(), 0);
    }

    void buttonsFollowThePhase_data()
    {
        QTest::addColumn<RunPhase>("phase");
        QTest::addColumn<bool>("play");
        QTest::addColumn<bool>("step");
        QTest::addColumn<bool>("reset");
        QTest::newRow("planning") << RunPhase::Planning << false << false << false;
        QTest::newRow("ready") << RunPhase::Ready << true << true << false;
        QTest::newRow("flying") << RunPhase::Flying << true << true << true;
        QTest::newRow("paused") << RunPhase::Paused << true << true << true;
        QTest::newRow("finished") << RunPhase::Finished << true << false << true;
        QTest::newRow("failed") << RunPhase::Failed << false << false << false;
    }

    void buttonsFollowThePhase()
    {
        QFETCH(RunPhase, phase);
        QFETCH(bool, play);
        QFETCH(bool, step);
        QFETCH(bool, reset);
        PlaybackBarFixture f;
        f.bar.showState(phase, 0, 1000);
        QCOMPARE(f.play.isEnabled(), play);
        QCOMPARE(f.step.isEnabled(), step);
        QCOMPARE(f.reset.isEnabled(), reset);
        QVERIFY(!f.play.toolTip().isEmpty());
    }

    void eachButtonAsksOnce()
    {
        PlaybackBarFixture f;
        f.bar.showState(RunPhase::Paused, 10, 1000);
        f.play.click();
        QCOMPARE(f.played.count(), 1);
        QCOMPARE(f.paused.count(), 0);
        f.bar.showState(RunPhase::Flying, 10, 1000);
        QCOMPARE(f.play.accessibleName(), u"Pause"_s);
        f.play.click();
        QCOMPARE(f.played.count(), 1);
        QCOMPARE(f.paused.count(), 1);
        f.step.click();
        f.reset.click();
        QCOMPARE(f.stepped.count(), 1);
        QCOMPARE(f.wasReset.count(), 1);
    }

    void rateIsEmittedByTheUserOnly()
    {
        PlaybackBarFixture f;
        QCOMPARE(f.bar.rate(), FlightRate(10));
        f.bar.setRate(50);
        QCOMPARE(f.bar.rate(), FlightRate(50));
        QCOMPARE(f.rateEdited.count(), 0);
        QTest::keyClick(&f.rate, Qt::Key_End);
        QCOMPARE(f.rateEdited.count(), 1);
        QCOMPARE(f.rateEdited.front().front().value<FlightRate>(), kFastestRate);
        QCOMPARE(f.bar.rate(), kFastestRate);
    }

    void nearestRateIsChosen_data()
    {
        QTest::addColumn<FlightRate>("asked");
        QTest::addColumn<FlightRate>("chosen");
        QTest::newRow("on offer") << FlightRate(20) << FlightRate(20);
        QTest::newRow("between") << FlightRate(40) << FlightRate(50);
        QTest::newRow("beyond") << FlightRate(1e6) << FlightRate(1000);
        QTest::newRow("slow motion") << FlightRate(0.11) << FlightRate(0.1);
        QTest::newRow("as fast as possible") << kFastestRate << kFastestRate;
    }

    void nearestRateIsChosen()
    {
        QFETCH(FlightRate, asked);
        QFETCH(FlightRate, chosen);
        PlaybackBarFixture f;
        f.bar.setRate(asked);
        QCOMPARE(f.bar.rate(), chosen);
    }

    void timeAndProgress()
    {
        PlaybackBarFixture f;
        const auto& time = test::child<QLineEdit>(f.bar, u"timeField"_s);
        const auto& length = test::child<QLabel>(f.bar, u"runLength"_s);
        const auto& line = test::child<RunTimeLine>(f.bar, u"timeLine"_s);
        f.bar.showState(RunPhase::Flying, 201, 1000);
        QCOMPARE(time.text(), u"03:21"_s);
        QCOMPARE(length.text(), u"/ 16:40"_s);
        QCOMPARE(line.value(), 201'000);
        QCOMPARE(line.maximum(), 201'000);
        f.bar.showState(RunPhase::Paused, 3725, 7200, 6000);
        QCOMPARE(time.text(), u"1:02:05"_s);
        QCOMPARE(length.text(), u"/ 2:00:00"_s);
        QCOMPARE(line.value(), 3'725'000);
        QCOMPARE(line.maximum(), 6'000'000);
        f.bar.showState(RunPhase::Ready, 0, 0);
        QCOMPARE(line.value(), 0);
    }

    void typedTimeIsEmittedOnce()
    {
        PlaybackBarFixture f;
        f.bar.showState(RunPhase::Paused, 201, 1000, 500);
        auto& time = test::child<QLineEdit>(f.bar, u"timeField"_s);
        f.bar.editTime();
        QTest::keyClicks(&time, u"2:05"_s);
        f.bar.showState(RunPhase::Paused, 202, 1000, 500);
        QCOMPARE(time.text(), u"2:05"_s); // typing is not disturbed
        QTest::keyClick(&time, Qt::Key_Return);
        QCOMPARE(f.timeEdited.count(), 1);
        QCOMPARE(f.timeEdited.front().front().toDouble(), 125.0);
        f.bar.editTime();
        QTest::keyClicks(&time, u"soon"_s);
        QTest::keyClick(&time, Qt::Key_Return);
        QCOMPARE(f.timeEdited.count(), 1);
        QCOMPARE(time.text(), u"03:22"_s); // what is shown again
    }

    void ratesStepAndStopAtTheEnds()
    {
        PlaybackBarFixture f;
        f.bar.setRate(500);
        f.bar.stepRate(+1);
        QCOMPARE(f.bar.rate(), FlightRate(1000));
        f.bar.stepRate(+5);
        QCOMPARE(f.bar.rate(), kFastestRate);
        f.bar.setRate(0.1);
        f.bar.stepRate(-1);
        QCOMPARE(f.bar.rate(), FlightRate(0.1));
    }

    void barLeavesTheMapNarrow()
    {
        const test::LongerTexts longer;
        PlaybackBarFixture f;
        f.bar.showState(RunPhase::Flying, 201, 1000);
        constexpr int kNarrowMap_px = 340; // below that the map itself is of no use
        QVERIFY2(f.bar.minimumSizeHint().width() <= kNarrowMap_px,
                 QByteArray::number(f.bar.minimumSizeHint().width()).constData());
    }

    void iconsAreReadable_data() { addThemes(); }

    void iconsAreReadable()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        for (int i = 0; i < kIconCount; ++i) {
            const QImage image = drawn(static_cast<IconName>(i), theme, 48);
            int inked = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const QColor colour = image.pixelColor(x, y);
                    if (colour.alpha() < 250)
                        continue;
                    ++inked;
                    // Lines that carry meaning: WCAG 2.1, 1.4.11.
                    QVERIFY(contrastRatio(colour, theme.panel) >= 3);
                }
            // A line of a tenth of the side across the icon at least, and far from a blot.
            QVERIFY2(inked > 48 * 48 / 25, QByteArray::number(i).constData());
            QVERIFY2(inked < 48 * 48 / 2, QByteArray::number(i).constData());
        }
    }

    void iconsDifferAndStayInside()
    {
        std::set<QByteArray> seen;
        for (int i = 0; i < kIconCount; ++i) {
            const QImage image = drawn(static_cast<IconName>(i), Theme::light(), 96);
            seen.insert(
                QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
            for (int at = 0; at < 96; ++at) {
                QCOMPARE(image.pixelColor(at, 0).alpha(), 0);
                QCOMPARE(image.pixelColor(at, 95).alpha(), 0);
                QCOMPARE(image.pixelColor(0, at).alpha(), 0);
                QCOMPARE(image.pixelColor(95, at).alpha(), 0);
            }
        }
        QCOMPARE(static_cast<int>(seen.size()), kIconCount);
    }

    void disabledIconsAreFainter()
    {
        const Theme theme = Theme::light();
        QVERIFY(drawn(IconName::Play, theme, 24) !=
                drawn(IconName::Play, theme, 24, QIcon::Disabled));
    }
};

QTEST_MAIN(TestPlaybackBar)
#include "tst_playback_bar.moc"

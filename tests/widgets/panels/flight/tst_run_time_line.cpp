#include "tests/support/window/panel_test.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/theme/palette.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** 1000 s of which 600 are flown and 300 are shown, 1012 px wide: one pixel a second. */
struct RunTimeLineFixture
{
    RunTimeLine line;
    QSignalSpy scrubbed{&line, &RunTimeLine::scrubbed};

    RunTimeLineFixture()
    {
        line.resize(1012, line.sizeHint().height());
        line.show();
        line.showTime(300, 600, 1000);
    }
    [[nodiscard]] QPoint at(int time_s) const { return {6 + time_s, line.height() / 2}; }
    [[nodiscard]] double last() const { return scrubbed.back().front().toDouble(); }
};

} // namespace

class TestRunTimeLine : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void showingEmitsNothing()
    {
        RunTimeLineFixture f;
        f.line.showTime(100, 700, 1000);
        QCOMPARE(f.scrubbed.count(), 0);
        QCOMPARE(f.line.value(), 100'000);
        QCOMPARE(f.line.maximum(), 700'000);
    }

    void pointOfNoReturnIsAPost()
    {
        RunTimeLineFixture f;
        const auto colourAt = [&](int time_s) {
            return f.line.grab().toImage().pixelColor(f.at(time_s).x(), 8);
        };
        const QColor empty = colourAt(850);
        f.line.setNoReturn(850);
        QCOMPARE(colourAt(850), Theme::light().uav);
        f.line.setNoReturn(1200); // after the end
        QCOMPARE(colourAt(850), empty);
    }

    void pressAndDrag()
    {
        RunTimeLineFixture f;
        QTest::mousePress(&f.line, Qt::LeftButton, {}, f.at(200));
        QCOMPARE(f.scrubbed.count(), 1);
        QVERIFY(std::abs(f.last() - 200) < 0.51); // half a pixel
        QMouseEvent move(QEvent::MouseMove, f.at(450), f.line.mapToGlobal(f.at(450)),
                         Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&f.line, &move);
        QVERIFY(std::abs(f.last() - 450) < 0.51);
        QTest::mouseRelease(&f.line, Qt::LeftButton, {}, f.at(450));
        QCOMPARE(f.scrubbed.count(), 2);
    }

    void notBeyondWhatWasFlown()
    {
        RunTimeLineFixture f;
        QTest::mouseClick(&f.line, Qt::LeftButton, {}, f.at(900));
        QCOMPARE(f.last(), 600.0);
        QTest::mouseClick(&f.line, Qt::LeftButton, {}, QPoint(0, 5));
        QCOMPARE(f.last(), 0.0);
    }

    void keysMoveTheInstant_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<double>("time_s");
        QTest::newRow("right") << Qt::Key_Right << 301.0;
        QTest::newRow("left") << Qt::Key_Left << 299.0;
        QTest::newRow("page up") << Qt::Key_PageUp << 330.0;
        QTest::newRow("home") << Qt::Key_Home << 0.0;
        QTest::newRow("end") << Qt::Key_End << 600.0;
    }

    void keysMoveTheInstant()
    {
        QFETCH(Qt::Key, key);
        QFETCH(double, time_s);
        RunTimeLineFixture f;
        QTest::keyClick(&f.line, key);
        QCOMPARE(f.scrubbed.count(), 1);
        QCOMPARE(f.last(), time_s);
    }

    void marksAreThoseWorthATick()
    {
        RunTimeLineFixture f;
        f.line.setMarks({{1, EventKind::Planned, u"a"_s},
                         {2, EventKind::Reached, u"b"_s},
                         {3, EventKind::Sighted, u"c"_s},
                         {4, EventKind::Intervention, u"d"_s}});
        QCOMPARE(f.line.marks().size(), std::size_t{2});
        const QImage with = f.line.grab().toImage();
        f.line.setMarks({});
        QVERIFY(with != f.line.grab().toImage());
    }

    void flownAndShownDiffer()
    {
        RunTimeLineFixture f;
        const QImage image = f.line.grab().toImage();
        const auto colour = [&](int time_s) { return image.pixelColor(f.at(time_s)); };
        QVERIFY(colour(100) != colour(450)); // behind the handle, flown
        QVERIFY(colour(450) != colour(800)); // flown, not yet flown
    }

    void pathAheadIsVisible_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    /** The contrast is at least 3 : 1, measured in an image. */
    void pathAheadIsVisible()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        RunTimeLine line;
        line.setTheme(theme);
        line.setPalette(paletteOf(theme));
        line.setAutoFillBackground(true);
        line.resize(300, 24);
        line.showTime(10, 20, 100);
        const QImage image = line.grab().toImage();
        const double contrast =
            contrastRatio(image.pixelColor(200, 12), line.palette().color(QPalette::Window));
        QVERIFY2(contrast >= 3, QByteArray::number(contrast));
    }
};

QTEST_MAIN(TestRunTimeLine)
#include "tst_run_time_line.moc"

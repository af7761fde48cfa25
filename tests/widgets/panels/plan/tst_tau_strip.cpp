#include "tests/support/approx.h"
#include "tests/support/plan/curve_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/forecast/curve_choice.h"
#include "widgets/panels/plan/tau_strip.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QVBoxLayout>

#include <cmath>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A slider that exposes the position of its handle. */
class OpenSlider final : public QSlider
{
public:
    using QSlider::QSlider;
    [[nodiscard]] QRect handle() const
    {
        QStyleOptionSlider option;
        initStyleOption(&option);
        return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    }
};

/** A slider with the strip below it, indented by different margins. */
struct TauStripFixture
{
    explicit TauStripFixture(int width_px = 300)
    {
        window.resize(width_px, 60);
        auto* column = new QVBoxLayout(&window);
        slider = new OpenSlider(Qt::Horizontal);
        slider->setRange(0, 500);
        strip = new TauStrip;
        column->addWidget(slider);
        column->addWidget(strip);
        strip->alignWith(slider);
        strip->setCurve(test::curveThrough({0.5, 0.52, 2, 5}));
        window.show();
        window.layout()->activate();
    }
    [[nodiscard]] QPoint at(double tau) const
    {
        return {static_cast<int>(std::lround(strip->xOf(tau))), strip->height() / 2};
    }
    [[nodiscard]] QColor colourAt(double tau) const
    {
        return strip->grab().toImage().pixelColor(at(tau));
    }

    QWidget window;
    OpenSlider* slider = nullptr;
    TauStrip* strip = nullptr;
};

QString toolTipAt(TauStrip& strip, double tau)
{
    const QPointF at(strip.xOf(tau), strip.height() / 2);
    QMouseEvent move(QEvent::MouseMove, at, strip.mapToGlobal(at), Qt::NoButton, {}, {});
    QCoreApplication::sendEvent(&strip, &move);
    return strip.toolTip();
}

/** Returns the number of different colours along the middle of a stretch of the band. */
int coloursAlong(TauStrip& strip, double from, double to)
{
    const QImage image = strip.grab().toImage();
    std::set<QRgb> colours;
    for (int x = static_cast<int>(strip.xOf(from)); x < static_cast<int>(strip.xOf(to)); ++x)
        colours.insert(image.pixel(x, strip.height() / 2));
    return static_cast<int>(colours.size());
}

} // namespace

class TestTauStrip : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void mapsTauAsTheSliderDoes_data()
    {
        QTest::addColumn<int>("width_px");
        QTest::newRow("narrow dock") << 220;
        QTest::newRow("usual") << 300;
        QTest::newRow("wide") << 900;
    }

    void mapsTauAsTheSliderDoes()
    {
        QFETCH(int, width_px);
        const TauStripFixture f(width_px);
        for (const int position : {0, 50, 250, 499, 500}) {
            f.slider->setValue(position);
            const double middle_px = f.slider->handle().center().x() + f.slider->x();
            // The handle stands on whole pixels.
            COMPARE_NEAR(f.strip->xOf(position / 100.0) + f.strip->x(), middle_px, 1.0);
        }
        COMPARE_NEAR(f.strip->tauAt(f.strip->xOf(1.25)), 1.25, 1e-9);
        QCOMPARE(f.strip->tauAt(-10), 0.0);
        QCOMPARE(f.strip->tauAt(2000), 5.0);
    }

    void worksWithoutASlider()
    {
        TauStrip strip;
        strip.resize(200, 16);
        QVERIFY(strip.xOf(0) > 0 && strip.xOf(5) < 200);
        COMPARE_NEAR(strip.tauAt(strip.xOf(3)), 3, 1e-9);
    }

    void showsThePresentPlan_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void showsThePresentPlan()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        const TauStripFixture f;
        f.strip->setTheme(theme);
        f.strip->setTau(1);
        QCOMPARE(f.colourAt(1).rgb(), theme.plan.rgb());
        QCOMPARE(f.colourAt(1.9).rgb(), theme.plan.rgb()); // the whole interval
        QVERIFY(f.colourAt(3).rgb() != theme.plan.rgb());
        f.strip->setTau(3);
        QCOMPARE(f.colourAt(3).rgb(), theme.plan.rgb());
        QVERIFY(f.colourAt(1).rgb() != theme.plan.rgb());
        f.strip->setTau(7); // beyond the strip
        QVERIFY(f.colourAt(3).rgb() != theme.plan.rgb());
    }

    /** An interval of a pixel is still visible for the present plan. */
    void narrowPlansAreVisible()
    {
        const TauStripFixture f;
        f.strip->setTau(0.51);
        QCOMPARE(f.colourAt(0.51).rgb(), Theme::light().plan.rgb());
    }

    void unprovenStretchesAreHatched()
    {
        const TauStripFixture f;
        f.strip->setTau(0.1);
        QCOMPARE(coloursAlong(*f.strip, 2.2, 4.8), 1);
        TauCurve partial = test::curveThrough({0.5, 2, 5});
        partial.complete = false;
        partial.intervals[2].proven = false;
        f.strip->setCurve(partial);
        QVERIFY(coloursAlong(*f.strip, 2.2, 4.8) > 1);
        QCOMPARE(coloursAlong(*f.strip, 0.7, 1.8), 1);
        f.strip->setCurve({}); // nothing known yet
        QVERIFY(coloursAlong(*f.strip, 0.2, 4.8) > 1);
        f.strip->setCurve({.complete = true}); // nothing to plan
        QCOMPARE(coloursAlong(*f.strip, 0.2, 4.8), 1);
    }

    void clickChoosesAPlan_data()
    {
        QTest::addColumn<double>("clicked");
        QTest::addColumn<double>("chosen");
        QTest::newRow("first") << 0.2 << 0.3; // the middle is 0.25
        QTest::newRow("third") << 1.7 << 1.3; // 1.26
        QTest::newRow("last") << 4.9 << 3.5;
    }

    void clickChoosesAPlan()
    {
        QFETCH(double, clicked);
        QFETCH(double, chosen);
        const TauStripFixture f;
        QSignalSpy spy(f.strip, &TauStrip::tauChosen);
        QTest::mouseClick(f.strip, Qt::LeftButton, {}, f.at(clicked));
        QCOMPARE(spy.count(), 1);
        COMPARE_NEAR(spy[0][0].toDouble(), chosen, 1e-12);
        QTest::mouseClick(f.strip, Qt::RightButton, {}, f.at(clicked));
        QCOMPARE(spy.count(), 1);
    }

    void clickOnNothingDoesNothing()
    {
        const TauStripFixture f;
        QSignalSpy spy(f.strip, &TauStrip::tauChosen);
        f.strip->setCurve({});
        QTest::mouseClick(f.strip, Qt::LeftButton, {}, f.at(1));
        QTest::keyClick(f.strip, Qt::Key_Right);
        QTest::keyClick(f.strip, Qt::Key_Home);
        QCOMPARE(spy.count(), 0);
    }

    void keysGoFromPlanToPlan()
    {
        const TauStripFixture f;
        f.strip->setTau(0.1);
        QObject::connect(f.strip, &TauStrip::tauChosen, f.strip, &TauStrip::setTau);
        QSignalSpy spy(f.strip, &TauStrip::tauChosen);
        const auto lastChosen = [&spy] { return spy.last()[0].toDouble(); };
        QTest::keyClick(f.strip, Qt::Key_Right);
        COMPARE_NEAR(lastChosen(), 0.51, 1e-12); // the narrow one is not skipped
        QTest::keyClick(f.strip, Qt::Key_Right);
        COMPARE_NEAR(lastChosen(), 1.3, 1e-12);
        QTest::keyClick(f.strip, Qt::Key_Left);
        COMPARE_NEAR(lastChosen(), 0.51, 1e-12);
        QTest::keyClick(f.strip, Qt::Key_End);
        COMPARE_NEAR(lastChosen(), 3.5, 1e-12);
        const auto chosen = spy.count();
        QTest::keyClick(f.strip, Qt::Key_Right); // the end
        QCOMPARE(spy.count(), chosen);
        QTest::keyClick(f.strip, Qt::Key_Home);
        COMPARE_NEAR(lastChosen(), 0.3, 1e-12);
        QVERIFY(!f.strip->previousPlan());
        QVERIFY(f.strip->nextPlan());
    }

    /** From a tau beyond the strip, the previous plan is the last one of the strip. */
    void plansBeforeATauBeyond()
    {
        const TauStripFixture f;
        f.strip->setTau(20);
        QVERIFY(!f.strip->nextPlan());
        COMPARE_NEAR(f.strip->previousPlan().value_or(0), 3.5, 1e-12);
    }

    void describesTheIntervalBelowThePointer()
    {
        const TauStripFixture f;
        f.strip->setLocale(QLocale(QLocale::English));
        QCOMPARE(toolTipAt(*f.strip, 1), u"τ 0.52 to 2.00: whole order 24.0 km, proven optimal"_s);
        TauCurve partial = test::curveThrough({0.5, 2, 5});
        partial.intervals[1].proven = false;
        f.strip->setCurve(partial);
        QVERIFY(toolTipAt(*f.strip, 1).endsWith(u"not proven"_s));
        f.strip->setCurve({});
        QVERIFY(!toolTipAt(*f.strip, 1).isEmpty());
    }

    void isReadAloud()
    {
        const TauStripFixture f;
        f.strip->setTau(1);
        QVERIFY(!f.strip->accessibleName().isEmpty());
        QVERIFY(f.strip->accessibleDescription().contains(u'4'));
        QVERIFY(f.strip->accessibleDescription().contains(u"24.0 km"_s));
        QCOMPARE(f.strip->focusPolicy(), Qt::StrongFocus);
    }

    void shortNumbersAreInside_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<double>("expected");
        QTest::newRow("wide") << 2.01861 << 5.0 << 3.5;
        QTest::newRow("two decimals") << 0.81335 << 0.829 << 0.82;
        QTest::newRow("three decimals") << 0.00127 << 0.00141 << 0.0013;
        QTest::newRow("not on its end") << 0.1 << 0.14 << 0.12;
    }

    void shortNumbersAreInside()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(double, expected);
        const double tau = shortTau({.tauFrom = from, .tauTo = to});
        COMPARE_NEAR(tau, expected, 1e-12);
        QVERIFY(tau > from && tau < to);
    }

    /**
     * In an interval of one rounding error no short number exists; any number inside is returned.
     */
    void shortNumberOfNothing()
    {
        const double from = 0.3;
        const double to = std::nextafter(from, 1);
        const double tau = shortTau({.tauFrom = from, .tauTo = to});
        QVERIFY(tau >= from && tau <= to);
    }
};

QTEST_MAIN(TestTauStrip)
#include "tst_tau_strip.moc"

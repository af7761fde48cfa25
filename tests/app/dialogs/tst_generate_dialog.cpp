#include "app/dialogs/generate_dialog.h"
#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/theme/quantity_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const WorldBounds kView{.min_m = {-1000, -2000}, .max_m = {9000, 4000}};

Scenario withArea()
{
    Scenario scenario = test::emptySea();
    scenario.area_m = {{0, 0}, {3000, 0}, {3000, 1000}, {1000, 1000}, {1000, 3000}, {0, 3000}};
    return scenario;
}

struct GenerateDialogFixture
{
    explicit GenerateDialogFixture(const Scenario& scenario = test::emptySea())
        : dialog(scenario, kView)
    {
        dialog.show();
    }
    [[nodiscard]] QSpinBox& spin(const QString& name)
    {
        return test::child<QSpinBox>(dialog, name);
    }
    [[nodiscard]] NumberField& number(const QString& name)
    {
        return test::child<NumberField>(dialog, name);
    }
    void choose(const QString& box, const QString& entry)
    {
        auto& combo = test::child<QComboBox>(dialog, box);
        QVERIFY(combo.findText(entry) >= 0);
        combo.setCurrentIndex(combo.findText(entry));
    }
    [[nodiscard]] QPushButton& ok() { return test::child<QPushButton>(dialog, u"generateOk"_s); }
    [[nodiscard]] QString state() { return test::child<QLabel>(dialog, u"generateState"_s).text(); }
    [[nodiscard]] const std::vector<Iceberg>& icebergs() const { return dialog.result().icebergs; }

    GenerateDialog dialog;
};

} // namespace

class TestGenerateDialog : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void aNumberIsTypedAtOnce()
    {
        GenerateDialogFixture f;
        QSpinBox& number = f.spin(u"generateNumber"_s);
        number.setFocus();
        QTest::keyClicks(&number, u"50"_s);
        QCOMPARE(number.value(), 50);
    }

    void drawsInTheViewAtFirst()
    {
        GenerateDialogFixture f;
        QCOMPARE(f.dialog.count(), 25);
        QVERIFY(!hasErrors(validate(f.dialog.result())));
        for (const Iceberg& iceberg : f.icebergs()) {
            QVERIFY((iceberg.position_m.array() >= kView.min_m.array()).all());
            QVERIFY((iceberg.position_m.array() <= kView.max_m.array()).all());
        }
        QVERIFY(f.ok().isEnabled());
    }

    void keepsToTheAreaWhereThereIsOne()
    {
        GenerateDialogFixture f(withArea());
        for (const Iceberg& iceberg : f.icebergs())
            QVERIFY(insidePolygon(withArea().area_m, iceberg.position_m));
    }

    void rectangleLiesInTheMiddleOfTheView()
    {
        GenerateDialogFixture f;
        QVERIFY(!f.number(u"generateWidth"_s).isEnabled());
        f.choose(u"generatePlace"_s, u"Rectangle in the middle of the map"_s);
        f.number(u"generateWidth"_s).setValue(2);
        f.number(u"generateHeight"_s).setValue(1);
        QVERIFY(f.number(u"generateWidth"_s).isEnabled());
        for (const Iceberg& iceberg : f.icebergs()) {
            QVERIFY(std::abs(iceberg.position_m.x() - 4000) <= 1000);
            QVERIFY(std::abs(iceberg.position_m.y() - 1000) <= 500);
        }
    }

    void everyChangeDrawsAnew()
    {
        GenerateDialogFixture f;
        QSignalSpy drawn(&f.dialog, &GenerateDialog::drawn);
        f.spin(u"generateNumber"_s).setValue(7);
        QCOMPARE(f.dialog.count(), 7);
        f.number(u"generateSpeedMin"_s).setValue(0.3);
        f.choose(u"generateDirection"_s, u"Around one direction"_s);
        f.number(u"generateTowards"_s).setValue(90);
        f.number(u"generateSpread"_s).setValue(10);
        f.number(u"generateSigmaMin"_s).setValue(9);
        f.number(u"generateGrowth"_s).setValue(0.5);
        QCOMPARE(drawn.count(), 7);
        for (const Iceberg& iceberg : f.icebergs()) {
            QVERIFY(iceberg.velocity_mps.x() > 0.29);
            QVERIFY(iceberg.sigma0_m2 >= 9);
            QCOMPARE(iceberg.q_m2ps, 0.5);
        }
    }

    void diceThrowAnotherField()
    {
        GenerateDialogFixture f;
        const Scenario first = f.dialog.result();
        auto& dice = test::child<QPushButton>(f.dialog, u"generateDice"_s);
        for (int i = 0; i < 3 && f.spin(u"generateSeed"_s).value() == 1; ++i)
            dice.click();
        QVERIFY(!(f.dialog.result() == first));
        f.spin(u"generateSeed"_s).setValue(1);
        QVERIFY(f.dialog.result() == first);
    }

    void addsOrReplaces()
    {
        GenerateDialogFixture f(randomScenario(3));
        f.spin(u"generateNumber"_s).setValue(5);
        QCOMPARE(f.icebergs().size(), std::size_t{17});
        QCOMPARE(f.state(), u"The scenario will have 17 icebergs."_s);
        test::child<QCheckBox>(f.dialog, u"generateReplace"_s).setChecked(true);
        QCOMPARE(f.icebergs().size(), std::size_t{5});
        QCOMPARE(f.icebergs().front().id, std::string("berg-1"));
    }

    void faultsAreShownAndNothingIsDrawn()
    {
        GenerateDialogFixture f(randomScenario(3));
        f.number(u"generateSpacing"_s).setValue(9000);
        QCOMPARE(f.dialog.count(), 0);
        QVERIFY(f.dialog.result() == randomScenario(3));
        QVERIFY(f.state().startsWith(u"Minimum distance between two icebergs: only "_s));
        QVERIFY2(f.state().contains(u" m from the others: choose fewer"_s), qPrintable(f.state()));
        QVERIFY(!f.ok().isEnabled());
        f.number(u"generateSpacing"_s).setValue(0);
        QVERIFY(f.ok().isEnabled());
        f.spin(u"generateNumber"_s).setValue(1000);
        QCOMPARE(f.state(), u"Number of icebergs: must be from 1 to 988, not 1\u202F000"_s);
        f.spin(u"generateNumber"_s).setValue(10);
        f.number(u"generateSpeedMin"_s).setValue(1);
        QCOMPARE(f.state(), u"Highest speed: must not be below \"Lowest speed\""_s);
        f.number(u"generateSpeedMin"_s).setValue(0);
        f.number(u"generateSigmaMin"_s).setValue(11);
        QCOMPARE(f.state(),
                 u"Largest σ at the start: must not be below \"Smallest σ at the start\""_s);
    }

    /** Fields are in the chosen units, icebergs in metres. */
    void nauticalUnits()
    {
        setShownUnits({.distance = DistanceUnit::Nautical, .speed = SpeedUnit::Knots});
        {
            GenerateDialogFixture f;
            f.choose(u"generatePlace"_s, u"Rectangle in the middle of the map"_s);
            f.number(u"generateWidth"_s).setValue(10);
            f.number(u"generateSpeedMin"_s).setValue(3);
            f.number(u"generateSpeedMax"_s).setValue(3);
            QCOMPARE(f.number(u"generateWidth"_s).suffix(), u" nmi"_s);
            double farthest_m = 0;
            for (const Iceberg& iceberg : f.icebergs()) {
                farthest_m = std::max(farthest_m, std::abs(iceberg.position_m.x() - 4000));
                COMPARE_NEAR(iceberg.velocity_mps.norm(), 3 * 1852.0 / 3600, 1e-3); // drawn to mm/s
            }
            QVERIFY(farthest_m > 2600 && farthest_m <= 9260); // 5 km across would give 2500
        }
        setShownUnits({});
    }

    void emptyRectangleIsRefused()
    {
        GenerateDialogFixture f;
        f.choose(u"generatePlace"_s, u"Rectangle in the middle of the map"_s);
        f.number(u"generateWidth"_s).setValue(0);
        QVERIFY(!f.ok().isEnabled());
        QCOMPARE(f.state(), u"Area: only 0 of 25 icebergs found a place: the area is too thin"_s);
    }
};

QTEST_MAIN(TestGenerateDialog)
#include "tst_generate_dialog.moc"

#include "core/tracking/position_error.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/theme/unit_settings.h"
#include "widgets/words/source_text.h"

#include <QComboBox>
#include <QHeaderView>
#include <QTableView>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

const Point kWater_m(2500, 2000);

QString planned(WindowFixture& w, int role = Qt::DisplayRole)
{
    const auto* model = test::child<QTableView>(w.window(), u"planTable"_s).model();
    return model->index(0, PlanModel::ArrivalSigma).data(role).toString();
}

/** Places one by the tool, where there is water. */
const Iceberg& place(WindowFixture& w)
{
    const std::size_t before = w.scenario().icebergs.size();
    w.trigger(u"icebergTool"_s);
    w.click(w.pixelOf(kWater_m));
    if (w.scenario().icebergs.size() != before + 1)
        qFatal("no iceberg was placed");
    return w.scenario().icebergs.back();
}

} // namespace

/** How uncertain positions are, in words of the sea, and what new ones are seen by. */
class TestMainWindowUncertainty : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }
    void cleanup() { setShownUnits({}); }

    void bothAreShownTheChosenOneFirst()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTRY_VERIFY(!planned(w).isEmpty());
        QVERIFY(!planned(w).endsWith(u" m"_s));
        QVERIFY2(planned(w, Qt::ToolTipRole).contains(u"σ "_s) &&
                     planned(w, Qt::ToolTipRole).contains(u"(95 % within "_s),
                 qPrintable(planned(w, Qt::ToolTipRole)));
        w.trigger(u"units/uncertainty-radius"_s);
        QTRY_VERIFY(planned(w).endsWith(u" m"_s));
        QVERIFY(planned(w, Qt::ToolTipRole).contains(u"(σ "_s));
        const auto& table = test::child<QTableView>(w.window(), u"icebergTable"_s);
        const QHeaderView& header = *table.horizontalHeader();
        QVERIFY(header.visualIndex(static_cast<int>(IcebergColumn::Radius95)) <
                header.visualIndex(static_cast<int>(IcebergColumn::Sigma)));
        w.trigger(u"units/uncertainty-sigma"_s);
        QTRY_VERIFY(!planned(w).endsWith(u" m"_s));
    }

    /** Either of the two is typed; the other follows. */
    void aRadiusIsTyped()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-1"});
        test::enter(test::child<NumberField>(w.window(), u"icebergRadius95"_s), u"0.5 nmi"_s);
        QVERIFY(std::abs(radius95_m(w.scenario().icebergs[0].sigma0_m2) - 926) < 1e-6);
        test::enter(test::child<NumberField>(w.window(), u"icebergs.sigma0_m2"_s), u"100"_s);
        QCOMPARE(test::child<NumberField>(w.window(), u"icebergRadius95"_s).text(), u"24.48 m"_s);
    }

    void newIcebergsAreAsUncertainAsTheirSource()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QCOMPARE(place(w).sigma0_m2, 150.0 * 150.0); // ship's radar
        const auto& source = test::child<QComboBox>(w.window(), u"icebergSource"_s);
        QCOMPARE(source.currentText(), sourceName(SightingSource::Radar));
        w.trigger(u"undoAction"_s);
        w.trigger(u"icebergs/source-visual"_s);
        QCOMPARE(place(w).sigma0_m2, 500.0 * 500.0);
        QCOMPARE(source.currentText(), sourceName(SightingSource::Visual));
    }

    /** The source chosen in the inspector also applies to new icebergs, and is stored. */
    void theLastSourceIsUsed()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-1"});
        auto& source = test::child<QComboBox>(w.window(), u"icebergSource"_s);
        QCOMPARE(source.currentIndex(), 0); // as typed
        const int satellite = source.findText(sourceName(SightingSource::Satellite));
        source.setCurrentIndex(satellite);
        emit source.activated(satellite);
        QCOMPARE(w.scenario().icebergs[0].sigma0_m2, 50.0 * 50.0);
        QVERIFY(w.action(u"icebergs/source-satellite"_s).isChecked());
        QCOMPARE(w.settings.value("icebergs/source").toString(), u"satellite"_s);
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario().icebergs[0].sigma0_m2 != 50.0 * 50.0);
        QCOMPARE(place(w).sigma0_m2, 50.0 * 50.0);
    }

    /** In flight as well: a new iceberg has the uncertainty of its source. */
    void inFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"icebergs/source-argos-beacon"_s);
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        w.trigger(u"icebergTool"_s);
        w.click(w.pixelOf(kWater_m));
        QVERIFY(w.until([&] { return w.record().now.icebergs.size() == 5; }));
        QCOMPARE(w.record().now.icebergs.back().sigma0_m2, 300.0 * 300.0);
    }
};

QTEST_MAIN(TestMainWindowUncertainty)
#include "tst_main_window_uncertainty.moc"

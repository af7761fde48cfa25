#include "widgets/panels/study/comparison_tables.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/tables/cell_model.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QResizeEvent>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kRow_px = 22;
constexpr int kCellMargins_px = 9;

enum Column
{
    FigureName,
    FigureOfReference,
    FigureOfOther,
    FigureDifference
};

struct ComparisonText
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonText)
};

QString signedText(double value, const QString& magnitude)
{
    return value == 0 ? magnitude : (value < 0 ? u"−"_s : u"+"_s) + magnitude;
}

/** Which values of a quantity are better. */
enum class Good
{
    Less,
    More,
    Neither
};

Better betterOf(double reference, double other, Good good)
{
    if (good == Good::Neither || reference == other)
        return Better::Neither;
    return (other < reference) == (good == Good::Less) ? Better::Other : Better::Reference;
}

/** Builds rows of quantities at the common time; without another run its columns stay empty. */
struct RowMaker
{
    RowMaker(const ComparedRun& referenceRun, const ComparedRun* otherRun)
    {
        double until_s = referenceRun.flown_s;
        if (otherRun != nullptr) {
            until_s = std::min(until_s, otherRun->flown_s);
            other = figuresAt(*otherRun, until_s);
        }
        reference = figuresAt(referenceRun, until_s);
    }

    /** Adds a row; `text` formats a value, `difference` a value and its reference. */
    template <class Value, class Text, class Difference>
    void add(const QString& label, const Value& value, Good good, const Text& text,
             const Difference& difference, const QString& toolTip)
    {
        const auto a = static_cast<double>(value(reference));
        ComparisonRow row{.label = label, .reference = text(a), .toolTip = toolTip};
        if (other) {
            const auto b = static_cast<double>(value(*other));
            row.other = text(b);
            row.difference = difference(b, a);
            row.better = betterOf(a, b, good);
        }
        rows.push_back(std::move(row));
    }

    RunFigures reference;
    std::optional<RunFigures> other;
    std::vector<ComparisonRow> rows;
};

QString clockDifference(double other_s, double reference_s)
{
    const double difference_s = std::round(other_s) - std::round(reference_s);
    return signedText(difference_s, clockText(std::abs(difference_s)));
}

QString icebergName(const ComparedRun& run, std::optional<std::size_t> iceberg)
{
    return iceberg ? shownName(run.icebergs[*iceberg]) : missingValueText();
}

UavTotals totalsOf(const RunFigures& figures, std::size_t uav)
{
    return uav < figures.uavs.size() ? figures.uavs[uav] : UavTotals();
}

double longest_s(const RunFigures& figures)
{
    return figures.longestUnseen ? figures.unseen[*figures.longestUnseen].longest_s : 0;
}

} // namespace

QString percentText(double value, double reference, const QLocale& locale)
{
    if (reference == 0)
        return missingValueText();
    return changeText(value / reference - 1, locale);
}

std::vector<ComparisonRow> figureRows(const ComparedRun& reference, const ComparedRun* other,
                                      const QLocale& locale)
{
    RowMaker maker(reference, other);
    const auto percent = [&](double value, double of) { return percentText(value, of, locale); };
    const auto whole = [&](double value) { return fixedText(value, 0, locale); };
    const auto wholeDifference = [&](double value, double of) {
        return signedText(value - of, whole(std::abs(value - of)));
    };
    const auto significant = [&](double value) { return significantText(value, 4, locale); };
    maker.add(
        ComparisonText::tr("Zeta ζ, m² s"), [](const RunFigures& f) { return f.zeta_m2s; },
        Good::Less, significant, percent,
        ComparisonText::tr("Accumulated uncertainty, Eq. (24): less is better."));
    maker.add(
        ComparisonText::tr("Mean Σσ, m²"), [](const RunFigures& f) { return f.meanSigmaSum_m2; },
        Good::Less, significant, percent,
        ComparisonText::tr("Mean total uncertainty of all icebergs: ζ divided by the flown time."));
    maker.add(
        ComparisonText::tr("Visits"), [](const RunFigures& f) { return f.visits; }, Good::More,
        whole, wholeDifference, ComparisonText::tr("Icebergs reached as targets."));
    maker.add(
        ComparisonText::tr("Plans"), [](const RunFigures& f) { return f.plans; }, Good::Neither,
        whole, wholeDifference, ComparisonText::tr("Number of plans made."));
    const QString unit = longDistanceUnit().name;
    const auto distance = [&](double value) { return significantText(value, 3, locale); };
    const auto distanceDifference = [&](double value, double of) {
        const double difference = std::round(10 * (value - of)) / 10;
        return signedText(difference, fixedText(std::abs(difference), 1, locale));
    };
    maker.add(
        ComparisonText::tr("Flown, %1").arg(unit),
        [](const RunFigures& f) { return longDistanceUnit().fromSi(f.flown_m); }, Good::Neither,
        distance, distanceDifference, ComparisonText::tr("Distance flown through the air."));
    maker.add(
        ComparisonText::tr("Longest unseen"), longest_s, Good::Less,
        [](double value) { return clockText(value); }, clockDifference,
        ComparisonText::tr("Longest time for which an iceberg was out of view."));
    maker.rows.push_back(
        {.label = ComparisonText::tr("Iceberg"),
         .reference = icebergName(reference, maker.reference.longestUnseen),
         .other = other ? icebergName(*other, maker.other->longestUnseen) : QString(),
         .toolTip = ComparisonText::tr("The iceberg that was out of view for the "
                                       "longest time.")});
    const std::vector<Uav>& uavs = reference.scenario.uavs;
    for (std::size_t i = 0; i < uavs.size(); ++i) {
        const QString name = nameInFleet(uavs, static_cast<int>(i));
        if (name.isEmpty())
            break; // a single UAV's figures are those of the flight
        maker.add(
            ComparisonText::tr("%1, visits").arg(name),
            [i](const RunFigures& f) { return totalsOf(f, i).visits; }, Good::Neither, whole,
            wholeDifference, ComparisonText::tr("Icebergs that %1 reached.").arg(name));
        maker.add(
            u"%1, %2"_s.arg(name, unit),
            [i](const RunFigures& f) { return longDistanceUnit().fromSi(totalsOf(f, i).flown_m); },
            Good::Neither, distance, distanceDifference,
            ComparisonText::tr("Distance that %1 has flown through the air.").arg(name));
    }
    return maker.rows;
}

std::vector<ComparisonRow> unseenRows(const ComparedRun& reference, const ComparedRun* other,
                                      const QLocale& locale)
{
    RowMaker maker(reference, other);
    for (std::size_t i = 0; i < maker.reference.unseen.size(); ++i)
        maker.add(
            icebergName(reference, static_cast<int>(i)),
            [i](const RunFigures& f) { return i < f.unseen.size() ? f.unseen[i].longest_s : 0; },
            Good::Less, [](double value) { return clockText(value); }, clockDifference,
            ComparisonText::tr("Unseen for %1 in total in A.")
                .arg(durationText(std::round(maker.reference.unseen[i].total_s), locale)));
    return maker.rows;
}

void setUpComparisonTable(QTableView& table, const QString& name, const QString& title)
{
    table.setObjectName(name);
    table.setAccessibleName(title);
    setUpDockTable(table, kRow_px);
    table.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QHeaderView* header = table.horizontalHeader();
    header->setSectionsClickable(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setMinimumSectionSize(1);
}

int widestText_px(const QTableView& table, int column, const QFont& font, const QString& least)
{
    const QFontMetrics metrics(font);
    const QAbstractItemModel& model = *table.model();
    int widest_px = metrics.horizontalAdvance(least);
    for (int row = 0; row < model.rowCount(); ++row)
        widest_px = std::max(widest_px,
                             metrics.horizontalAdvance(model.index(row, column).data().toString()));
    return widest_px;
}

ComparisonTable::ComparisonTable(const QString& name, const QString& title, QWidget* parent)
    : QTableView(parent), m_model(new CellModel(this))
{
    setModel(m_model);
    showRows({}); // the columns, which setting up needs
    setUpComparisonTable(*this, name, title);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::TabFocus);
    horizontalHeader()->setSectionResizeMode(FigureName, QHeaderView::Stretch);
}

void ComparisonTable::setTheme(const Theme& theme)
{
    setDockTableTheme(*this, theme);
    setColumnWidths();
}

void ComparisonTable::showRows(std::vector<ComparisonRow> rows)
{
    const auto shown = std::make_shared<const std::vector<ComparisonRow>>(std::move(rows));
    const auto rowOf = [shown](int row) -> const ComparisonRow& {
        return (*shown)[static_cast<std::size_t>(row)];
    };
    const auto column = [&](const QString& title, QString ComparisonRow::*text) {
        return CellColumn{.title = title, .text = [=](int row) { return rowOf(row).*text; }};
    };
    CellSheet sheet{.columns = withNumbers({column({}, &ComparisonRow::label),
                                            column(tr("A"), &ComparisonRow::reference),
                                            column(tr("B"), &ComparisonRow::other),
                                            column(tr("B − A"), &ComparisonRow::difference)}),
                    .rows = static_cast<int>(shown->size()),
                    .toolTip = [=](int row, int /*column*/) { return rowOf(row).toolTip; },
                    .other = [=, this](int row, int column, int role) -> QVariant {
                        const Better better = rowOf(row).better;
                        const bool isBetter =
                            (column == FigureOfReference && better == Better::Reference) ||
                            (column == FigureOfOther && better == Better::Other);
                        if (role != Qt::FontRole || !isBetter)
                            return {};
                        QFont bold = font();
                        bold.setBold(true);
                        return bold;
                    }};
    m_model->setSheet(std::move(sheet));
    setColumnWidths();
}

/** Numbers take the width they need, up to a quarter of the table each. */
void ComparisonTable::setColumnWidths()
{
    QFont bold = font();
    bold.setBold(true);
    const int most_px = viewport()->width() / 4;
    for (const int column : {FigureOfReference, FigureOfOther, FigureDifference})
        setColumnWidth(
            column,
            std::min(widestText_px(*this, column, bold, u"00:00"_s) + kCellMargins_px, most_px));
}

void ComparisonTable::resizeEvent(QResizeEvent* event)
{
    QTableView::resizeEvent(event);
    setColumnWidths();
}

} // namespace berg

#include "widgets/panels/icebergs/iceberg_table_paste.h"

#include "core/checks/validate.h"
#include "core/earth/geodesy.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/iceberg_table_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IcebergPasteText
{
    Q_DECLARE_TR_FUNCTIONS(IcebergPasteText)
};

using PastedLine = std::vector<QString>;

bool isBlank(const PastedLine& line)
{
    return std::all_of(line.begin(), line.end(),
                       [](const QString& cell) { return cell.trimmed().isEmpty(); });
}

/** Pastes line by line into a copy of the scenario. */
class Paste
{
public:
    Paste(const Scenario& scenario, const PasteTarget& target, const IcebergColumnSpecs& specs,
          const QLocale& locale)
        : m_target(target), m_columns(target.columns), m_specs(specs), m_locale(locale)
    {
        m_outcome.scenario = scenario;
    }

    [[nodiscard]] PasteOutcome run(const std::vector<PastedLine>& lines)
    {
        if (std::all_of(lines.begin(), lines.end(), isBlank)) {
            m_outcome.fault = IcebergPasteText::tr("There is no text to paste.");
            return std::move(m_outcome);
        }
        std::size_t first = 0;
        if (lines.size() > 1 && readTitles(lines.front()))
            first = 1;
        for (std::size_t i = first; i < lines.size() && m_outcome.fault.isEmpty(); ++i) {
            m_line = i + 1;
            pasteLine(lines[i], i - first);
        }
        return std::move(m_outcome);
    }

private:
    /**
     * Returns whether all cells of the line are column titles, which then determine the columns.
     */
    [[nodiscard]] bool readTitles(const PastedLine& line)
    {
        std::vector<IcebergColumn> columns;
        for (const QString& cell : line)
            for (const IcebergColumn column : m_target.shown)
                if (cell.trimmed() == specOf(m_specs, column).copied)
                    columns.push_back(column);
        if (columns.size() != line.size())
            return false;
        m_columns = std::move(columns);
        return true;
    }

    void pasteLine(const PastedLine& line, std::size_t row)
    {
        if (isBlank(line))
            return;
        const bool isNew = row >= m_target.ids.size();
        if (isNew && !addIceberg(line))
            return;
        Iceberg& iceberg = isNew ? m_outcome.scenario.icebergs.back()
                                 : *findById(m_outcome.scenario.icebergs, m_target.ids[row]);
        m_outcome.ids.push_back(iceberg.id);
        Drift drift;
        m_before = placeOf(iceberg);
        m_place.reset();
        for (std::size_t i = 0; i < line.size() && m_outcome.fault.isEmpty(); ++i) {
            if (line[i].trimmed().isEmpty())
                continue;
            if (i >= m_columns.size()) {
                fail(IcebergPasteText::tr(
                         "Row %1 has a cell \"%2\" to the right of the last column.")
                         .arg(m_line)
                         .arg(shortened(line[i])));
                return;
            }
            pasteCell(iceberg, drift, m_columns[i], line[i]);
        }
        setDrift(iceberg, drift); // sets speed and direction together
        if (m_outcome.fault.isEmpty() && m_place)
            setPlace(iceberg, *m_place);
    }

    [[nodiscard]] bool addIceberg(const PastedLine& line)
    {
        Scenario& scenario = m_outcome.scenario;
        if (scenario.icebergs.size() >= kMostIcebergs) {
            fail(IcebergPasteText::tr("Row %1: %2", "row, fault")
                     .arg(QString::number(m_line),
                          issueSentence(IssueId::IcebergCount,
                                        {countOf(kMostIcebergs), countOf(kMostIcebergs + 1)})));
            return false;
        }
        Iceberg iceberg = m_target.added;
        iceberg.id = freshIcebergId(scenario);
        for (std::size_t i = 0; i < std::min(line.size(), m_columns.size()); ++i) {
            const std::string name = line[i].trimmed().toStdString();
            if (m_columns[i] == IcebergColumn::Name && !name.empty() && isFree(name))
                iceberg.id = name;
        }
        scenario.icebergs.push_back(iceberg);
        return true;
    }

    [[nodiscard]] bool isFree(const std::string& id) const
    {
        return findById(m_outcome.scenario.icebergs, id) == nullptr &&
               findById(m_outcome.scenario.uavs, id) == nullptr;
    }

    void pasteCell(Iceberg& iceberg, Drift& drift, IcebergColumn column, const QString& cell)
    {
        if (column == IcebergColumn::Name) {
            const std::string& label = iceberg.name.empty() ? iceberg.id : iceberg.name;
            if (cell.toStdString() == label)
                return; // unchanged copy, including spaces
            const std::string name = cell.trimmed().toStdString();
            iceberg.name = name == iceberg.id ? std::string() : name;
            return;
        }
        const IcebergColumnSpec& spec = specOf(m_specs, column);
        if (!spec.isEditable())
            return; // a derived column named by a title
        if (spec.half) {
            readPlace(iceberg, spec, cell);
            return;
        }
        const std::optional<double> value = numberOf(cell, m_locale);
        if (!value) {
            fail(IcebergPasteText::tr("Row %1, column \"%2\": \"%3\" is not a number.")
                     .arg(m_line)
                     .arg(spec.title, shortened(cell)));
            return;
        }
        const Limits limits = spec.number->range(m_outcome.scenario);
        const bool isThere = isShownAs(iceberg, column, spec, *value);
        if (!isThere && outOfLimits(*value, limits)) {
            fail(IcebergPasteText::tr("Row %1, column \"%2\": %3 is not from %4 to %5.")
                     .arg(m_line)
                     .arg(spec.title, shortened(cell), fixedText(limits.low, 0, m_locale),
                          fixedText(limits.high, 0, m_locale)));
            return;
        }
        // An unchanged value stays the same to the last bit in any unit.
        const std::optional<double> number =
            isThere ? icebergNumber(iceberg, column) : spec.unit.toSi(*value);
        if (column == IcebergColumn::Speed)
            drift.speed_mps = number;
        else if (column == IcebergColumn::Direction)
            drift.direction_deg = number;
        else
            setIcebergNumber(iceberg, column, *number);
    }

    [[nodiscard]] LatLon placeOf(const Iceberg& iceberg) const
    {
        return LocalFrame(m_outcome.scenario.origin).toGeographic(iceberg.position_m);
    }

    /** Returns whether the cell is an unchanged copy of this half of the position. */
    [[nodiscard]] bool isCopyOf(const LatLon& place, PlaceHalf half, const QString& cell) const
    {
        return cell.trimmed() ==
               copiedAngle(half == PlaceHalf::Latitude ? place.latitude_deg : place.longitude_deg,
                           m_locale);
    }

    void readPlace(const Iceberg& iceberg, const IcebergColumnSpec& spec, const QString& cell)
    {
        // An angle that was only copied along must not undo changes by the cells beside it.
        if (isCopyOf(m_before, *spec.half, cell) || isCopyOf(placeOf(iceberg), *spec.half, cell))
            return;
        const auto typed = typedPlace(cell, *spec.half, m_place.value_or(placeOf(iceberg)));
        if (const auto* reason = std::get_if<QString>(&typed))
            fail(IcebergPasteText::tr("Row %1, column \"%2\", \"%3\": %4")
                     .arg(m_line)
                     .arg(spec.title, shortened(cell), *reason));
        else
            m_place = std::get<LatLon>(typed);
    }

    /** Sets the position; an unchanged one stays the same to the last bit. */
    void setPlace(Iceberg& iceberg, const LatLon& place)
    {
        const LatLon origin = m_outcome.scenario.origin;
        if (place == placeOf(iceberg))
            return;
        if (const std::optional<Point> at_m = pointInReach(place, origin))
            iceberg.position_m = *at_m;
        else
            fail(IcebergPasteText::tr("Row %1: %2")
                     .arg(m_line)
                     .arg(beyondReachText(place, origin, m_locale)));
    }

    [[nodiscard]] static QString shortened(const QString& cell)
    {
        constexpr int kLongest = 40;
        const QString text = cell.simplified();
        return text.size() > kLongest ? text.left(kLongest) + u'…' : text;
    }

    void fail(const QString& reason)
    {
        m_outcome.fault = reason + u' ' + IcebergPasteText::tr("Nothing was pasted.");
    }

    const PasteTarget& m_target;
    std::vector<IcebergColumn> m_columns;
    const IcebergColumnSpecs& m_specs;
    QLocale m_locale;
    std::size_t m_line = 0;        ///< line of the text, from 1
    LatLon m_before;               ///< position of the line's iceberg before
    std::optional<LatLon> m_place; ///< position of the line, as far as it has been read
    PasteOutcome m_outcome;
};

} // namespace

PasteOutcome pasteCells(const Scenario& scenario, const QString& text, const PasteTarget& target,
                        const IcebergColumnSpecs& specs, const QLocale& locale)
{
    return Paste(scenario, target, specs, locale).run(cellsOf(text, locale));
}

} // namespace berg

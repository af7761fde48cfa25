#include "app/dialogs/import_options_view.h"

#include "widgets/panels/fields/entry_field.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/words/source_text.h"
#include "widgets/words/time_entry.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimeZone>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kGap_px = 5;
constexpr double kHighestError_m = 1e6;
constexpr double kHighestGrowth_m2ps = 1e6;

/** Returns the time in a form that `readTime` reads. */
QString lineText(UtcTime time)
{
    return QDateTime::fromMSecsSinceEpoch(time.time_since_epoch().count(), QTimeZone::utc())
        .toString(u"yyyy-MM-dd HH:mm:ss 'UTC'"_s);
}

std::optional<UtcTime> timeIn(const QString& text)
{
    const auto read = readTime(text, std::nullopt);
    const auto* time = std::get_if<UtcTime>(&read);
    return time != nullptr ? std::optional(*time) : std::nullopt;
}

} // namespace

GeoBox boxRound(std::span<const LatLon> outline)
{
    if (outline.empty())
        return {};
    GeoBox box{.south_deg = 90, .west_deg = 0, .north_deg = -90, .east_deg = 0};
    double turned_deg = 0; // angle turned from the first place, not cut at the antimeridian
    double west_deg = 0;
    double east_deg = 0;
    double before_deg = outline.front().longitude_deg;
    double latitudes_deg = 0;
    for (std::size_t i = 0; i <= outline.size(); ++i) {
        const LatLon& place = outline[i % outline.size()];
        turned_deg += std::remainder(place.longitude_deg - before_deg, 360.0);
        before_deg = place.longitude_deg;
        west_deg = std::min(west_deg, turned_deg);
        east_deg = std::max(east_deg, turned_deg);
        box.south_deg = std::min(box.south_deg, place.latitude_deg);
        box.north_deg = std::max(box.north_deg, place.latitude_deg);
        latitudes_deg += place.latitude_deg;
    }
    if (std::abs(turned_deg) > 180 || east_deg - west_deg >= 360) { // the outline encloses a pole
        (latitudes_deg < 0 ? box.south_deg : box.north_deg) = latitudes_deg < 0 ? -90 : 90;
        box.west_deg = -180;
        box.east_deg = 180;
        return box;
    }
    const auto wrapped = [&](double turn_deg) {
        return std::remainder(outline.front().longitude_deg + turn_deg, 360.0);
    };
    box.west_deg = wrapped(west_deg);
    box.east_deg = wrapped(east_deg);
    return box;
}

ImportOptionsView::ImportOptionsView(const QString& presentName, bool intoNew, QWidget* parent)
    : QWidget(parent), m_form(new QFormLayout(this))
{
    const ImportOptions standard;
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(kGap_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addTarget(presentName, intoNew);
    addDates();
    m_at = addTime(u"importAt"_s, tr("S&tart at"),
                   tr("UTC time that becomes the start of the scenario. Otherwise its start stays, "
                      "or moves to the last sighting if that is later."));
    m_since = addTime(u"importSince"_s, tr("Not &before"), tr("Earlier sightings are left out."));
    m_until = addTime(u"importUntil"_s, tr("Not &after"), tr("Later sightings are left out."));
    addArea();
    addSource();
    m_error = addNumber(u"importPositionError"_s, tr("Position &error"),
                        tr("Standard deviation of a position along each axis if the file states "
                           "none and no column names the source."),
                        kMarkedPlace_m, kHighestError_m, 1, u" m"_s);
    connect(m_error, &NumberField::edited, this, [this] {
        m_errorChosen = true;
        m_source->setCurrentIndex(m_source->count() - 1);
    });
    m_spread = addNumber(u"importSpread"_s, tr("Drift &variation"),
                         tr("Standard deviation of an unknown drift along each axis. With 0 the "
                            "drift counts as known and constant."),
                         standard.track.drift.velocitySpread_mps, 5, 3, u" m/s"_s);
    m_velocityTime =
        addNumber(u"importVelocityTime"_s, tr("Drift &changes in"),
                  tr("Time after which a known drift is no longer valid. 0 means never."),
                  standard.track.drift.velocityTime_s / 3600, 1e5, 2, u" h"_s);
    m_growth =
        addNumber(u"importGrowth"_s, tr("&Growth q"),
                  tr("Growth of the uncertainty if there are too few sightings to estimate it."),
                  standard.q_m2ps, kHighestGrowth_m2ps, 6, u" m²/s"_s);
    addTracks();
    enableInputs();
}

void ImportOptionsView::addTarget(const QString& presentName, bool intoNew)
{
    m_target = new QComboBox;
    m_target->setObjectName(u"importTarget"_s);
    m_target->addItem(tr("This scenario"));
    m_target->addItem(tr("A new scenario"));
    m_target->setItemData(0, presentName, Qt::ToolTipRole);
    m_target->setToolTip(tr("Icebergs already in this scenario are updated by their ids."));
    m_target->setCurrentIndex(intoNew ? 1 : 0);
    guardWheel(*m_target);
    connect(m_target, &QComboBox::currentIndexChanged, this, &ImportOptionsView::edited);
    m_form->addRow(tr("&Into"), m_target);
}

/** The choice sets the position error, which can also be typed. */
void ImportOptionsView::addSource()
{
    m_source = new QComboBox;
    m_source->setObjectName(u"importSource"_s);
    m_source->addItem(tr("As stated in the file"));
    for (const SightingSource source : kSightingSources)
        m_source->addItem(sourceName(source), static_cast<int>(source));
    m_source->addItem(tr("As typed"));
    m_source->setToolTip(tr("Sensor that found the positions. Rows whose column “source”, “method” "
                            "or “sensor” names another source use its error."));
    guardWheel(*m_source);
    connect(m_source, &QComboBox::activated, this, [this] {
        const QVariant source = m_source->currentData();
        m_errorChosen = m_source->currentIndex() > 0;
        if (source.isValid() || !m_errorChosen)
            m_error->showValue(source.isValid()
                                   ? errorOf(static_cast<SightingSource>(source.toInt())).sd_m
                                   : m_fileError_m);
        emit edited();
    });
    m_form->addRow(tr("Seen b&y"), m_source);
}

/** Shown only if the file leaves the order of dates open. */
void ImportOptionsView::addDates()
{
    m_dates = new QComboBox;
    m_dates->setObjectName(u"importDates"_s);
    m_dates->addItem(tr("Automatic"));
    m_dates->addItem(tr("Month first: 12/31/2021"), static_cast<int>(DateOrder::MonthFirst));
    m_dates->addItem(tr("Day first: 31/12/2021"), static_cast<int>(DateOrder::DayFirst));
    m_dates->setToolTip(tr("How to read dates such as 05/02/2021."));
    guardWheel(*m_dates);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &ImportOptionsView::edited);
    m_form->addRow(tr("Dat&es"), m_dates);
    m_form->setRowVisible(m_dates, false);
}

ImportOptionsView::TimeRow ImportOptionsView::addTime(const QString& name, const QString& text,
                                                      const QString& toolTip)
{
    auto* box = new QCheckBox(text);
    box->setObjectName(name + u"Box"_s);
    box->setToolTip(toolTip);
    const auto faultOf = [](const QString& typed) {
        const auto read = readTime(typed, std::nullopt);
        const auto* fault = std::get_if<QString>(&read);
        return fault != nullptr ? *fault : QString();
    };
    const TimeRow row{.box = box,
                      .edit = new EntryField(
                          {.key = name, .label = QString(text).remove(u'&'), .toolTip = toolTip},
                          EntryField::ValidationTime::WhenFinished, faultOf)};
    row.edit->showText(lineText(UtcTime(std::chrono::seconds(946'684'800)))); // the year 2000
    connect(row.box, &QCheckBox::toggled, this, [this] {
        enableInputs();
        emit edited();
    });
    connect(row.edit, &EntryField::edited, this, &ImportOptionsView::edited);
    m_form->addRow(row.box, row.edit);
    return row;
}

void ImportOptionsView::addArea()
{
    m_areaBox = new QCheckBox(tr("Insi&de"));
    m_areaBox->setObjectName(u"importAreaBox"_s);
    m_areaBox->setToolTip(tr("Sightings outside these latitudes and longitudes are left out."));
    m_presentView = new QPushButton(tr("Visible part of the &map"));
    m_presentView->setObjectName(u"importPresentView"_s);
    m_presentView->setAutoDefault(false);
    connect(m_presentView, &QPushButton::clicked, this, &ImportOptionsView::presentViewRequested);
    m_form->addRow(m_areaBox, m_presentView);
    const QStringList words{tr("South"), tr("West"), tr("North"), tr("East")};
    const std::array<double, 4> highest_deg = {90, 360, 90, 360};
    const std::array<double, 4> first_deg = {-90, -180, 90, 180};
    auto* grid = new QGridLayout;
    grid->setSpacing(kGap_px);
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
        auto* edge = new NumberField;
        edge->setObjectName(u"importEdge%1"_s.arg(i));
        edge->setNumberFormat({.least = 0, .most = 4}, u"°"_s);
        edge->setAccessibleName(words[qsizetype(i)]);
        edge->limit(-highest_deg[i] + (highest_deg[i] > 90 ? 180 : 0), highest_deg[i]);
        edge->showValue(first_deg[i]);
        connect(edge, &NumberField::edited, this, &ImportOptionsView::edited);
        const int column = i % 2 == 0 ? 0 : 2;
        grid->addWidget(new QLabel(words[qsizetype(i)]), static_cast<int>(i / 2), column);
        grid->addWidget(withRemark(edge), static_cast<int>(i / 2), column + 1);
        m_edges[i] = edge;
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    m_form->addRow(grid);
    connect(m_areaBox, &QCheckBox::toggled, this, [this] {
        enableInputs();
        emit edited();
    });
}

NumberField* ImportOptionsView::addNumber(const QString& name, const QString& label,
                                          const QString& toolTip, double value, double highest,
                                          int decimals, const QString& unit)
{
    auto* field = new NumberField;
    field->setObjectName(name);
    field->setToolTip(toolTip);
    field->setNumberFormat({.least = 0, .most = decimals}, unit);
    field->limit(0, highest);
    field->showValue(value);
    connect(field, &NumberField::edited, this, &ImportOptionsView::edited);
    addNumberRow(*m_form, label, field);
    return field;
}

void ImportOptionsView::addTracks()
{
    m_tracks = new QCheckBox(tr("With &recorded tracks"));
    m_tracks->setObjectName(u"importTracks"_s);
    m_tracks->setToolTip(tr(
        "Sightings after the start become the true motion of an iceberg. Requires a start time."));
    connect(m_tracks, &QCheckBox::toggled, this, &ImportOptionsView::edited);
    m_form->addRow(m_tracks);
}

void ImportOptionsView::enableInputs()
{
    for (const TimeRow& row : {m_at, m_since, m_until})
        row.edit->setEnabled(row.box->isChecked());
    for (NumberField* edge : m_edges)
        edge->setEnabled(m_areaBox->isChecked());
    m_tracks->setEnabled(m_at.box->isChecked());
}

void ImportOptionsView::showFile(const SightingSummary& file)
{
    m_fileError_m = file.positionSd_m;
    if (!file.guessedDate.empty())
        m_form->setRowVisible(m_dates, true);
    if (!m_errorChosen)
        m_error->showValue(file.positionSd_m);
    if (!file.first || !file.last)
        return;
    const auto show = [](const TimeRow& row, UtcTime time) {
        if (!row.box->isChecked())
            row.edit->showText(lineText(time));
    };
    show(m_at, *file.last);
    show(m_since, *file.first);
    show(m_until, *file.last);
}

void ImportOptionsView::setArea(const GeoBox& box)
{
    const std::array<double, 4> edges_deg = {box.south_deg, box.west_deg, box.north_deg,
                                             box.east_deg};
    for (std::size_t i = 0; i < m_edges.size(); ++i)
        m_edges[i]->showValue(edges_deg[i]);
    if (m_areaBox->isChecked())
        emit edited();
    else
        m_areaBox->setChecked(true);
}

void ImportOptionsView::setInFlight(bool inFlight)
{
    for (QWidget* input : std::initializer_list<QWidget*>{m_target, m_at.edit, m_tracks})
        m_form->setRowVisible(input, !inFlight);
}

bool ImportOptionsView::intoNew() const
{
    return m_target->currentIndex() == 1;
}

void ImportOptionsView::chooseNew()
{
    m_target->setCurrentIndex(1);
}

std::optional<DateOrder> ImportOptionsView::dates() const
{
    const QVariant chosen = m_dates->currentData();
    return chosen.isValid() ? std::optional(static_cast<DateOrder>(chosen.toInt())) : std::nullopt;
}

ImportOptions ImportOptionsView::options() const
{
    const auto timeOf = [](const TimeRow& row) {
        return row.box->isChecked() ? timeIn(row.edit->text()) : std::nullopt;
    };
    ImportOptions options{.at = timeOf(m_at), .since = timeOf(m_since), .until = timeOf(m_until)};
    if (m_areaBox->isChecked())
        options.area = GeoBox{.south_deg = m_edges[0]->value(),
                              .west_deg = m_edges[1]->value(),
                              .north_deg = m_edges[2]->value(),
                              .east_deg = m_edges[3]->value()};
    if (m_errorChosen)
        options.positionSd_m = m_error->value();
    options.track.drift = {.velocitySpread_mps = m_spread->value(),
                           .velocityTime_s = m_velocityTime->value() * 3600};
    options.q_m2ps = m_growth->value();
    options.withTracks = options.at && m_tracks->isChecked();
    return options;
}

} // namespace berg

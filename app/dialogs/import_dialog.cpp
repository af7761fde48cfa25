#include "app/dialogs/import_dialog.h"

#include "app/dialogs/escape_key.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/flight_sightings.h"
#include "widgets/panels/dialogs/import_columns_view.h"
#include "widgets/panels/dialogs/import_options_view.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/words/import_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>

#include <unordered_map>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kSize_px(1230, 740);
constexpr int kSettings_px = 300;
constexpr int kTabs_px = 250;
constexpr int kProgress_px = 120;
constexpr int kErrorMargin_px = 24;

QString fileSizeText(const QString& path, const QLocale& locale)
{
    return locale.formattedDataSize(QFileInfo(path).size());
}

/** What is new has a plus before its name, what is updated an asterisk. */
MapPicture pictureOf(const ImportPreview& preview)
{
    std::unordered_map<std::string, ImportOutcome> outcomes;
    for (const ImportRow& row : preview.rows)
        if (row.taken)
            outcomes.emplace(row.report.id, row.report.outcome);
    MapPicture picture = withScenario({}, preview.result.scenario);
    picture.air = {}; // no sighting says anything about it
    for (MapIceberg& iceberg : picture.icebergs) {
        const auto found = outcomes.find(iceberg.key);
        if (found == outcomes.end())
            continue;
        if (found->second == ImportOutcome::Added)
            iceberg.id = u"+ "_s + iceberg.id;
        else if (found->second == ImportOutcome::Updated)
            iceberg.id = u"* "_s + iceberg.id;
    }
    picture.emptyTitle = ImportDialog::tr("No icebergs");
    picture.emptyHint = ImportDialog::tr("None of the sightings is taken.");
    return picture;
}

} // namespace

ImportDialog::ImportDialog(ImportRunner& runner, const ImportOffer& offer, QWidget* parent)
    : QDialog(parent)
    , m_runner(runner)
    , m_offer(offer)
    , m_new(std::make_shared<const Scenario>(scenarioFor(offer.path)))
{
    setWindowTitle(tr("Import sightings from %1").arg(QFileInfo(offer.path).fileName()));
    setSizeGripEnabled(true);
    auto* sides = new QHBoxLayout;
    sides->setSpacing(12);
    sides->addWidget(makeSettings());
    sides->addWidget(makeResults(), 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(sides, 1);
    column->addLayout(makeFoot());
    setCaptionTheme(*this, offer.theme);
    m_map->setTheme(offer.theme);
    closeOnEscape(*this);
    connect(&m_runner, &ImportRunner::ready, this, &ImportDialog::take);
    resize(kSize_px);
    request(true);
}

ImportDialog::~ImportDialog()
{
    m_runner.clear();
    // What shows members of the dialog goes before them.
    delete m_map;
    delete m_tabs;
}

QWidget* ImportDialog::makeSettings()
{
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("&Format"));
    m_format = new QComboBox;
    m_format->setObjectName(u"importFormat"_s);
    m_format->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    label->setBuddy(m_format);
    guardWheel(*m_format);
    fillFormats();
    connect(m_format, &QComboBox::activated, this, &ImportDialog::changeFormat);
    column->addWidget(label);
    column->addWidget(m_format);
    column->addSpacing(8);
    const QString name = QString::fromStdString(m_offer.present->name);
    m_options = new ImportOptionsView(name, m_offer.intoNew);
    m_options->setInFlight(m_offer.inFlight);
    connect(m_options, &ImportOptionsView::edited, this, [this] { request(false); });
    connect(m_options, &ImportOptionsView::presentViewRequested, this,
            [this] { m_options->setArea(boxRound(m_map->outline())); });
    column->addWidget(m_options);
    column->addStretch(1);
    side->setFixedWidth(std::max(kSettings_px, side->sizeHint().width()));
    return side;
}

QWidget* ImportDialog::makeResults()
{
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    m_map = new MapView(m_document, m_selection);
    m_map->setObjectName(u"importMap"_s);
    m_map->setAccessibleName(tr("Map of what comes out"));
    m_map->setLocked(true);
    m_error = new QLabel;
    m_error->setObjectName(u"importError"_s);
    m_error->setWordWrap(true);
    m_error->setAlignment(Qt::AlignCenter);
    m_error->setMargin(kErrorMargin_px);
    m_error->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_outcome = new QStackedWidget;
    m_outcome->addWidget(m_map);
    m_outcome->addWidget(m_error);
    column->addWidget(m_outcome, 1);
    m_summary = new QLabel;
    m_summary->setObjectName(u"importSummary"_s);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_summary->setFont(m_offer.theme.strong());
    m_legend = new CaptionLabel(m_offer.inFlight ? tr("+ appears   * reported seen")
                                                 : tr("+ new   * updated"));
    auto* line = new QHBoxLayout;
    line->addWidget(m_summary);
    m_intoNew = new QPushButton(tr("Import into a &new scenario"));
    m_intoNew->setObjectName(u"importNewButton"_s);
    m_intoNew->setAutoDefault(false);
    m_intoNew->setVisible(false);
    connect(m_intoNew, &QPushButton::clicked, this, [this] { m_options->chooseNew(); });
    line->addWidget(m_intoNew);
    line->addStretch(1);
    line->addWidget(m_legend);
    column->addLayout(line);
    m_scene = new CaptionLabel;
    m_scene->setObjectName(u"importScene"_s);
    column->addWidget(m_scene);
    m_icebergTable = newCellTable(m_icebergs, u"importIcebergs"_s, tr("Icebergs of the file"));
    m_columns = new ImportColumnsView;
    connect(m_columns, &ImportColumnsView::edited, this, [this] { request(false); });
    m_tabs = new QTabWidget;
    m_tabs->setObjectName(u"importTabs"_s);
    m_tabs->addTab(m_icebergTable, tr("Icebergs"));
    m_rejectedTable = newCellTable(m_rejected, u"importRejected"_s, tr("Rejected rows"));
    m_tabs->addTab(m_rejectedTable, tr("Rejected rows"));
    m_tabs->addTab(m_columns, tr("Columns"));
    m_tabs->setFixedHeight(kTabs_px);
    column->addWidget(m_tabs);
    connect(m_icebergTable->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ImportDialog::selectOnMap);
    connect(&m_selection, &Selection::changed, this, &ImportDialog::selectRow);
    return side;
}

QLayout* ImportDialog::makeFoot()
{
    auto* row = new QHBoxLayout;
    m_progress = new QProgressBar;
    m_progress->setRange(0, 0); // how far it is nobody knows
    m_progress->setFixedWidth(kProgress_px);
    m_progress->setTextVisible(false);
    auto* buttons = new QDialogButtonBox;
    m_import = buttons->addButton(m_offer.inFlight ? tr("Re&port") : tr("Im&port"),
                                  QDialogButtonBox::AcceptRole);
    m_import->setObjectName(u"importButton"_s);
    m_import->setDefault(true);
    QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    cancel->setObjectName(u"importCancel"_s);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    row->addWidget(m_progress);
    row->addStretch(1);
    row->addWidget(buttons);
    return row;
}

void ImportDialog::fillFormats()
{
    m_format->addItem(tr("Automatic"), u"auto"_s);
    for (const ImportFormat& format : importFormats())
        m_format->addItem(importFormatName(format.id),
                          QString::fromUtf8(format.id.data(), qsizetype(format.id.size())));
}

void ImportDialog::changeFormat()
{
    m_columns->clear(); // another format has other columns
    request(false);
}

void ImportDialog::request(bool atOnce)
{
    const ImportOptions options = m_options->options();
    m_runner.start(
        {.path = m_offer.path,
         .reading = {.format = m_format->currentData().toString().toStdString(),
                     .mapping = m_columns->mapping(),
                     .dates = m_options->dates()},
         .oneIceberg = m_options->oneIceberg(),
         .base = m_options->intoNew() ? m_new : m_offer.present,
         .options = m_offer.inFlight ? optionsInFlight(options, *m_offer.present) : options},
        atOnce);
    showState();
}

void ImportDialog::take(const PreviewPointer& preview)
{
    const PreviewPointer before = std::exchange(m_preview, preview);
    if (preview->file) {
        m_options->showFile(*preview->file);
        m_format->setItemText(0, tr("Automatic: %1").arg(importFormatName(preview->file->format)));
    }
    showOutcome();
    showTables();
    if (preview->error && !preview->file && !preview->head.columns.isEmpty())
        m_tabs->setCurrentWidget(m_columns); // naming them may help
    else if (!preview->error && preview->rows.empty() && m_tabs->currentWidget() == m_icebergTable)
        m_tabs->setCurrentWidget(m_rejectedTable); // which tells why
    else if (!preview->rows.empty() && before != nullptr && before->rows.empty() &&
             m_tabs->currentWidget() == m_rejectedTable)
        m_tabs->setCurrentWidget(m_icebergTable);
    showState();
}

/** The map, or why there is none. */
void ImportDialog::showOutcome()
{
    if (m_preview->error) {
        m_error->setText(importErrorReport(*m_preview->error));
        m_outcome->setCurrentWidget(m_error);
        return;
    }
    const LatLon origin = m_preview->result.scenario.origin;
    const bool isElsewhere = m_shownOrigin != origin;
    m_shownOrigin = origin;
    m_map->setPicture(pictureOf(*m_preview));
    m_outcome->setCurrentWidget(m_map);
    if (isElsewhere)
        m_map->fit();
}

void ImportDialog::showTables()
{
    m_icebergs.setSheet(icebergSheet(m_preview, locale()));
    m_rejected.setSheet(rejectedSheet(m_preview, locale()));
    m_columns->showPreview(m_preview);
    m_icebergTable->resizeColumnsToContents();
    m_icebergTable->horizontalHeader()->setStretchLastSection(true);
    m_rejectedTable->resizeColumnsToContents();
    m_rejectedTable->horizontalHeader()->setStretchLastSection(true);
    const std::size_t listed = m_preview->rows.size();
    const Rejections& rejected = m_preview->result.rejected;
    m_tabs->setTabText(
        0, m_preview->moreRows == 0
               ? tr("Icebergs (%1)").arg(listed)
               : tr("Icebergs (first %1 of %2)").arg(listed).arg(listed + m_preview->moreRows));
    m_tabs->setTabText(
        1,
        rejected.count == rejected.first.size()
            ? tr("Rejected rows (%1)").arg(rejected.count)
            : tr("Rejected rows (first %1 of %2)").arg(rejected.first.size()).arg(rejected.count));
}

/** What can be done now: a preview of an earlier request is not to be imported, and looks so. */
void ImportDialog::showState()
{
    const bool busy = m_runner.isBusy();
    const bool usable = !busy && m_preview && m_preview->isUsable();
    m_progress->setVisible(busy);
    m_icebergTable->setEnabled(!busy);
    m_rejectedTable->setEnabled(!busy);
    m_import->setEnabled(usable);
    m_legend->setVisible(usable);
    // Sightings that do not fit to the scenario that is shown do to one of their own.
    const bool isOffered = !busy && !usable && m_preview && m_preview->file &&
                           !m_options->intoNew() && !m_offer.inFlight;
    m_intoNew->setVisible(isOffered);
    QStringList lines;
    if (usable && !m_preview->file->guessedDate.empty())
        lines << guessedDateText(m_preview->file->guessedDate, m_preview->file->guessedLine);
    if (usable && !m_preview->result.scene.empty())
        lines << sceneSummary(m_preview->result.scene);
    if (usable && m_preview->result.observerSet)
        lines << tr("Velocities are not known exactly, so the observer becomes the Kalman filter.");
    const QString scene = lines.join(u'\n');
    m_scene->setText(scene);
    m_scene->setToolTip(scene); // all of it, where it is wider than the dialog
    m_scene->setVisible(!scene.isEmpty());
    if (busy && !m_preview)
        m_summary->setText(
            tr("Reading %1, %2 ...")
                .arg(QFileInfo(m_offer.path).fileName(), fileSizeText(m_offer.path, locale())));
    else if (busy)
        m_summary->setText(tr("Working ..."));
    else
        m_summary->setText(m_preview->error ? QString() : importSummary(m_preview->result));
}

/** The iceberg of a row is marked on the map. */
void ImportDialog::selectOnMap()
{
    std::vector<std::string> ids;
    for (const QModelIndex& index : m_icebergTable->selectionModel()->selectedRows())
        ids.push_back(index.data().toString().toStdString());
    m_selection.set(std::move(ids));
}

/** The row of an iceberg that was clicked on the map. */
void ImportDialog::selectRow()
{
    if (m_selection.ids().size() != 1)
        return;
    const QString id = QString::fromStdString(m_selection.ids().front());
    const QAbstractItemModel& model = *m_icebergTable->model();
    const QModelIndexList found =
        model.match(model.index(0, 0), Qt::DisplayRole, id, 1, Qt::MatchExactly);
    if (found.isEmpty() || m_icebergTable->selectionModel()->isRowSelected(found.front().row()))
        return;
    m_icebergTable->selectRow(found.front().row());
}

std::optional<ImportChoice> ImportDialog::choice() const
{
    if (m_runner.isBusy() || !m_preview || !m_preview->isUsable())
        return std::nullopt;
    const ImportResult& result = m_preview->result;
    return ImportChoice{.scenario = result.scenario,
                        .intoNew = m_options->intoNew(),
                        .icebergs = static_cast<int>(result.added + result.updated),
                        .reports =
                            m_offer.inFlight ? reportsOf(*m_preview) : std::vector<Intervention>()};
}

} // namespace berg

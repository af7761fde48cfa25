#include "app/dialogs/import_dialog.h"

#include "app/dialogs/escape_key.h"
#include "app/dialogs/import_columns_view.h"
#include "app/dialogs/import_identity_view.h"
#include "app/dialogs/import_options_view.h"
#include "app/dialogs/import_rows_view.h"
#include "core/io/import/import_formats.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/sightings/flight_sightings.h"
#include "widgets/words/import_text.h"

#include <QCheckBox>
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
constexpr int kInputs_px = 300;
constexpr int kTabs_px = 250;
constexpr int kProgress_px = 120;
constexpr int kErrorMargin_px = 24;

QString fileSizeText(const QString& path, const QLocale& locale)
{
    return locale.formattedDataSize(QFileInfo(path).size());
}

/** Marks new icebergs with a plus, updated ones with an asterisk. */
MapPicture pictureOf(const ImportPreview& preview)
{
    std::unordered_map<std::string, ImportOutcome> outcomes;
    for (const ImportRow& row : preview.rows)
        if (row.taken)
            outcomes.emplace(row.report.id, row.report.outcome);
    MapPicture picture = withScenario({}, preview.result.scenario);
    picture.air = {}; // no sighting says anything about it
    for (MapIceberg& iceberg : picture.icebergs) {
        const auto found = outcomes.find(keyOf(iceberg));
        if (found == outcomes.end())
            continue;
        if (found->second == ImportOutcome::Added)
            iceberg.id = u"+ "_s + iceberg.id;
        else if (found->second == ImportOutcome::Updated)
            iceberg.id = u"* "_s + iceberg.id;
    }
    picture.emptyTitle = ImportDialog::tr("No icebergs");
    picture.emptyHint = ImportDialog::tr("No sighting can be imported.");
    return picture;
}

/** The first of the icebergs that need consent. */
QString doubtfulIds(const ImportPreview& preview)
{
    constexpr qsizetype kMostNamed = 5;
    QStringList ids;
    for (const ImportRow& row : preview.rows)
        if (isDoubtful(row.report)) {
            if (ids.size() == kMostNamed)
                return ids.join(u", "_s) + u", …"_s;
            ids << QString::fromStdString(row.report.id);
        }
    return ids.join(u", "_s);
}

} // namespace

ImportDialog::ImportDialog(ImportRunner& runner, const ImportOffer& offer, QWidget* parent,
                           QSettings* settings)
    : QDialog(parent)
    , m_runner(runner)
    , m_offer(offer)
    , m_settings(settings)
    , m_new(std::make_shared<const Scenario>(scenarioFor(offer.path)))
{
    setWindowTitle(tr("Import sightings from %1").arg(QFileInfo(offer.path).fileName()));
    setSizeGripEnabled(true);
    auto* sides = new QHBoxLayout;
    sides->setSpacing(12);
    sides->addWidget(makeInputs());
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
    // Widgets that use members are deleted before these.
    delete m_map;
    delete m_tabs;
}

QWidget* ImportDialog::makeInputs()
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
            [this] { m_options->setArea(boxRound(m_map->camera().outline())); });
    column->addWidget(m_options);
    column->addStretch(1);
    side->setFixedWidth(std::max(kInputs_px, side->sizeHint().width()));
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
    m_identity = new ImportIdentityView;
    connect(m_identity, &ImportIdentityView::edited, this, [this] { request(false); });
    column->addWidget(m_identity);
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
    connect(m_columns, &ImportColumnsView::edited, this, [this] {
        m_isRecalled = false;
        showMemory();
        request(false);
    });
    connect(m_columns, &ImportColumnsView::forgetRequested, this, &ImportDialog::forget);
    connect(this, &QDialog::accepted, this, &ImportDialog::keepColumns);
    m_tabs = new QTabWidget;
    m_tabs->setObjectName(u"importTabs"_s);
    m_tabs->addTab(m_icebergTable, tr("Icebergs"));
    for (const auto list : {ImportRowsView::List::Rejected, ImportRowsView::List::Noted,
                            ImportRowsView::List::Outside}) {
        auto* rows = new ImportRowsView(list);
        m_tabs->addTab(rows, rows->title());
        m_rowLists[static_cast<std::size_t>(list)] = rows;
    }
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
    m_consent =
        new QCheckBox(m_offer.inFlight ? tr("Report all t&he same") : tr("Import all t&he same"));
    m_consent->setObjectName(u"importConsent"_s);
    m_consent->setVisible(false);
    connect(m_consent, &QCheckBox::toggled, this, [this] { showState(); });
    row->addWidget(m_progress);
    row->addStretch(1);
    row->addWidget(m_consent);
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
    m_identity->clear();
    request(false);
}

void ImportDialog::request(bool atOnce)
{
    const ImportOptions options = m_options->options();
    m_runner.start(
        {.path = m_offer.path,
         .reading = {.format = m_format->currentData().toString().toStdString(),
                     .mapping = m_columns->mapping(),
                     .dates = m_options->dates(),
                     .headerLine = m_columns->headerLine()},
         .identity = m_identity->chosen(),
         .base = m_options->intoNew() ? m_new : m_offer.present,
         .options = m_offer.inFlight ? optionsInFlight(options, *m_offer.present) : options},
        atOnce);
    showState();
}

void ImportDialog::take(const PreviewPointer& preview)
{
    const PreviewPointer before = std::exchange(m_preview, preview);
    m_consent->setChecked(false); // it was given to another result
    m_identity->showChoices(preview->file ? preview->file->choices : std::vector<IdentityChoice>());
    if (preview->file) {
        m_options->showFile(*preview->file);
        m_format->setItemText(0, tr("Automatic: %1").arg(importFormatName(preview->file->format)));
    }
    showOutcome();
    showTables();
    recallColumns();
    const bool isUnclear = preview->file && preview->file->isUnclear;
    const bool wasUnclear = before && before->file && before->file->isUnclear;
    if (isUnclear || (preview->error && !preview->file && !preview->head.columns.isEmpty()))
        m_tabs->setCurrentWidget(m_columns); // naming them may help
    else if (!preview->error && preview->rows.empty() && m_tabs->currentWidget() == m_icebergTable)
        m_tabs->setCurrentWidget(m_rowLists.front()); // it shows the reason
    else if (!preview->rows.empty() &&
             (wasUnclear || (before != nullptr && before->rows.empty() &&
                             m_tabs->currentWidget() == m_rowLists.front())))
        m_tabs->setCurrentWidget(m_icebergTable);
    showState();
}

void ImportDialog::recallColumns()
{
    const QStringList& header = m_preview->head.columns;
    const QString fingerprint = headerFingerprint(header);
    if (m_settings == nullptr || header.isEmpty() || m_recalledFor == fingerprint)
        return;
    m_recalledFor = fingerprint;
    if (m_columns->mapping().empty() && m_columns->choose(columnsFor(*m_settings, header))) {
        m_isRecalled = true;
        request(true);
    }
    showMemory();
}

/** Remembers the columns that the user chose, for the next file with this header. */
void ImportDialog::keepColumns()
{
    const QStringList header = m_preview ? m_preview->head.columns : QStringList();
    if (m_settings == nullptr || header.isEmpty())
        return;
    if (const ColumnMapping mapping = m_columns->mapping(); !mapping.empty())
        rememberColumns(*m_settings, header, mapping);
    else if (!columnsFor(*m_settings, header).empty())
        forgetColumns(*m_settings, headerFingerprint(header));
}

void ImportDialog::forget(const QString& fingerprint)
{
    for (const RememberedColumns& known : rememberedColumns(*m_settings))
        if (fingerprint.isEmpty() || known.fingerprint == fingerprint)
            forgetColumns(*m_settings, known.fingerprint);
    if (std::exchange(m_isRecalled, false)) {
        m_columns->clear();
        request(true);
    }
    showMemory();
}

void ImportDialog::showMemory()
{
    if (m_settings != nullptr)
        m_columns->showMemory(rememberedColumns(*m_settings), m_isRecalled);
}

/** The map, or why there is none. */
void ImportDialog::showOutcome()
{
    if (m_preview->error) {
        m_error->setText(importErrorReport(*m_preview->error));
        m_outcome->setCurrentWidget(m_error);
        return;
    }
    if (m_preview->file && m_preview->file->isUnclear) {
        m_error->setText(tr("Choose below which rows belong to the same iceberg."));
        m_outcome->setCurrentWidget(m_error);
        return;
    }
    const LatLon origin = m_preview->result.scenario.origin;
    const bool isElsewhere = m_shownOrigin != origin;
    m_shownOrigin = origin;
    m_map->setPicture(pictureOf(*m_preview));
    m_outcome->setCurrentWidget(m_map);
    if (isElsewhere)
        m_map->camera().fit();
}

void ImportDialog::showTables()
{
    m_icebergs.setSheet(icebergSheet(m_preview, locale()));
    m_columns->showPreview(m_preview);
    m_icebergTable->resizeColumnsToContents();
    m_icebergTable->horizontalHeader()->setStretchLastSection(true);
    const std::size_t listed = m_preview->rows.size();
    m_tabs->setTabText(
        0, m_preview->moreRows == 0
               ? tr("Icebergs (%1)").arg(listed)
               : tr("Icebergs (first %1 of %2)").arg(listed).arg(listed + m_preview->moreRows));
    for (ImportRowsView* rows : m_rowLists) {
        rows->showPreview(m_preview);
        m_tabs->setTabText(m_tabs->indexOf(rows), rows->title());
        m_tabs->setTabVisible(m_tabs->indexOf(rows),
                              rows == m_rowLists.front() || !rows->isEmpty());
    }
}

/** Enables the buttons that are possible now. A preview of an earlier request is greyed and not
 * importable. */
void ImportDialog::showState()
{
    const bool busy = m_runner.isBusy();
    const bool usable = !busy && m_preview && m_preview->isUsable();
    const bool isUnclear = m_preview && m_preview->file && m_preview->file->isUnclear;
    m_progress->setVisible(busy);
    m_icebergTable->setEnabled(!busy);
    for (ImportRowsView* rows : m_rowLists)
        rows->setEnabled(!busy);
    m_import->setEnabled(usable && isAgreed());
    m_consent->setVisible(usable && m_preview->needsConsent);
    m_legend->setVisible(usable);
    // Sightings that do not fit to the scenario that is shown do to one of their own.
    const bool isOffered = !busy && !usable && m_preview && m_preview->file && !isUnclear &&
                           !m_options->intoNew() && !m_offer.inFlight;
    m_intoNew->setVisible(isOffered);
    showRemarks(usable);
    if (busy && !m_preview)
        m_summary->setText(
            tr("Reading %1, %2 ...")
                .arg(QFileInfo(m_offer.path).fileName(), fileSizeText(m_offer.path, locale())));
    else if (busy)
        m_summary->setText(tr("Working ..."));
    else
        m_summary->setText(m_preview->error || isUnclear ? QString()
                                                         : importSummary(m_preview->result));
}

bool ImportDialog::isAgreed() const
{
    return !m_preview->needsConsent || m_consent->isChecked();
}

/** Shows the lines above the tables, which concern the whole import. */
void ImportDialog::showRemarks(bool usable)
{
    QStringList lines;
    if (usable && m_preview->needsConsent)
        lines << tr("Faster than 1.5 m/s or on land: %1. Check columns, units and ids.")
                     .arg(doubtfulIds(*m_preview));
    if (usable && !m_preview->file->guessedDate.empty())
        lines << guessedDateText(m_preview->file->guessedDate, m_preview->file->guessedLine);
    if (const QString far = !m_runner.isBusy() && m_preview && !m_preview->error
                                ? farSightingsText(m_preview->result, !m_options->intoNew())
                                : QString();
        !far.isEmpty())
        lines << far;
    if (usable && !m_preview->result.scene.empty())
        lines << sceneSummary(m_preview->result.scene);
    if (usable && m_preview->result.observerSet)
        lines << tr("Velocities are uncertain, so the scenario will use the Kalman filter.");
    const QString scene = lines.join(u'\n');
    m_scene->setText(scene);
    m_scene->setToolTip(scene); // all of it, where it is wider than the dialog
    m_scene->setVisible(!scene.isEmpty());
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
    if (m_runner.isBusy() || !m_preview || !m_preview->isUsable() || !isAgreed())
        return std::nullopt;
    const ImportResult& result = m_preview->result;
    return ImportChoice{.scenario = result.scenario,
                        .intoNew = m_options->intoNew(),
                        .icebergs = static_cast<int>(result.added + result.updated),
                        .reports =
                            m_offer.inFlight ? reportsOf(*m_preview) : std::vector<Intervention>()};
}

} // namespace berg

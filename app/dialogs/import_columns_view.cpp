#include "app/dialogs/import_columns_view.h"

#include "core/io/import/import_formats.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/words/import_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kFields_px = 300;
constexpr int kMostColumn_px = 180;
constexpr int kMostLine = 1000;         ///< largest line number of a header
constexpr qsizetype kLongestEntry = 60; ///< longest menu entry, characters

/** Returns the column names of the combo boxes, in the order of the file. */
QStringList columnsOf(const ImportPreview& preview)
{
    QStringList columns = preview.file ? preview.file->columns : preview.head.columns;
    columns.removeAll(QString());
    columns.removeDuplicates();
    return columns;
}

QString guessOf(const ImportPreview& preview, SightingField field)
{
    if (preview.file)
        for (const FieldColumn& mapped : preview.file->mapping)
            if (mapped.field == field)
                return QString::fromStdString(mapped.column);
    return {};
}

} // namespace

ImportColumnsView::ImportColumnsView(QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    m_words = new QLabel(tr("This format has no columns to choose."));
    m_words->setWordWrap(true);
    m_fields = new QWidget;
    auto* form = new QFormLayout(m_fields);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const auto& named : kSightingFieldNames) {
        auto* combo = new QComboBox;
        combo->setObjectName(u"column-"_s +
                             QString::fromUtf8(named.name.data(), qsizetype(named.name.size())));
        combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        guardWheel(*combo);
        connect(combo, &QComboBox::activated, this, &ImportColumnsView::edited);
        form->addRow(sightingFieldName(named.value), combo);
        m_combos.push_back(combo);
    }
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(kFields_px);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_fields);
    auto* side = new QVBoxLayout;
    side->addWidget(m_words);
    side->addWidget(makeMemory());
    side->addWidget(makeHeaderLine());
    side->addWidget(scroll, 1);
    row->addLayout(side);
    m_table = newCellTable(m_rows, u"importHead"_s, tr("First rows of the file"));
    m_table->setSortingEnabled(false);
    m_table->horizontalHeader()->setMaximumSectionSize(kMostColumn_px);
    row->addWidget(m_table, 1);
    m_words->setVisible(false);
    clear();
}

QWidget* ImportColumnsView::makeHeaderLine()
{
    m_headerRow = new QWidget;
    auto* row = new QHBoxLayout(m_headerRow);
    row->setContentsMargins(0, 0, 0, 0);
    m_headerLine = new QSpinBox;
    m_headerLine->setObjectName(u"importHeaderLine"_s);
    m_headerLine->setRange(0, kMostLine);
    m_headerLine->setSpecialValueText(tr("Automatic"));
    m_headerLine->setKeyboardTracking(false);
    m_headerLine->setToolTip(
        tr("Line of the file that names the columns, if a title precedes it."));
    guardWheel(*m_headerLine);
    auto* label = new QLabel(tr("&Header line"));
    label->setBuddy(m_headerLine);
    row->addWidget(label);
    row->addWidget(m_headerLine, 1);
    connect(m_headerLine, &QSpinBox::valueChanged, this, &ImportColumnsView::edited);
    return m_headerRow;
}

QWidget* ImportColumnsView::makeMemory()
{
    auto* memory = new QWidget;
    auto* column = new QVBoxLayout(memory);
    column->setContentsMargins(0, 0, 0, 0);
    m_inUse = new QLabel(tr("Columns as for the last file with this header."));
    m_inUse->setObjectName(u"importColumnsInUse"_s);
    m_inUse->setWordWrap(true);
    m_memory = new QPushButton(tr("&Forget columns"));
    m_memory->setObjectName(u"importForget"_s);
    m_memory->setAutoDefault(false);
    m_memory->setToolTip(tr("Headers whose columns were chosen by hand in an earlier import."));
    m_memoryMenu = new QMenu(m_memory);
    m_memory->setMenu(m_memoryMenu);
    column->addWidget(m_inUse);
    column->addWidget(m_memory);
    m_inUse->setVisible(false);
    m_memory->setVisible(false);
    return memory;
}

void ImportColumnsView::showMemory(const std::vector<RememberedColumns>& all, bool isInUse)
{
    m_inUse->setVisible(isInUse);
    m_memory->setVisible(!all.empty());
    m_memoryMenu->clear();
    const auto add = [this](const QString& text, const QString& fingerprint) {
        connect(m_memoryMenu->addAction(text), &QAction::triggered, this,
                [this, fingerprint] { emit forgetRequested(fingerprint); });
    };
    for (const RememberedColumns& known : all) {
        QString names = known.header.join(u", "_s);
        if (names.size() > kLongestEntry)
            names = names.left(kLongestEntry - 1) + u'\u2026';
        add(names.replace(u'&', u"&&"_s), known.fingerprint);
    }
    m_memoryMenu->addSeparator();
    add(tr("All of them"), {});
}

bool ImportColumnsView::choose(const ColumnMapping& mapping)
{
    bool isAny = false;
    for (const FieldColumn& mapped : mapping) {
        QComboBox& combo = *m_combos.at(static_cast<std::size_t>(mapped.field));
        const int row = combo.findData(QString::fromStdString(mapped.column));
        isAny = isAny || row > 0;
        combo.setCurrentIndex(std::max(0, row));
    }
    return isAny;
}

std::optional<std::size_t> ImportColumnsView::headerLine() const
{
    const int line = m_headerLine->value();
    return line > 0 ? std::optional(static_cast<std::size_t>(line)) : std::nullopt;
}

void ImportColumnsView::clear()
{
    const QSignalBlocker silent(m_headerLine); // the caller requests a preview itself
    m_headerLine->setValue(0);
    for (QComboBox* combo : m_combos)
        fill(*combo, {}, {});
}

void ImportColumnsView::fill(QComboBox& combo, const QStringList& columns, const QString& guess)
{
    const QString chosen = combo.currentIndex() > 0 ? combo.currentData().toString() : QString();
    combo.clear();
    combo.addItem(guess.isEmpty() ? tr("Automatic") : tr("Automatic: %1").arg(guess));
    for (const QString& column : columns)
        combo.addItem(column, column);
    combo.setCurrentIndex(chosen.isEmpty() ? 0 : std::max(0, combo.findData(chosen)));
}

void ImportColumnsView::showPreview(const PreviewPointer& preview)
{
    const ImportFormat* format = preview->file ? findImportFormat(preview->file->format) : nullptr;
    const QStringList columns = columnsOf(*preview);
    const bool mayMap = (format == nullptr || format->namedColumns) && !columns.isEmpty();
    for (std::size_t i = 0; i < m_combos.size(); ++i) {
        const QString guess = guessOf(*preview, kSightingFieldNames[i].value);
        QComboBox& combo = *m_combos[i];
        fill(combo, mayMap ? columns : QStringList(),
             guess == combo.currentData().toString() ? QString() : guess);
    }
    const bool isTable = mayMap || (headerLine() && !preview->head.columns.isEmpty());
    m_headerRow->setVisible(isTable || m_headerLine->value() > 0);
    const std::size_t found = preview->file ? preview->file->headerLine.value_or(0) : 0;
    if (!headerLine())
        m_headerLine->setSpecialValueText(found > 0 ? tr("Automatic: %1").arg(found)
                                                    : tr("Automatic"));
    m_fields->setVisible(mayMap);
    m_words->setVisible(!mayMap);
    m_rows.setSheet(headSheet(preview));
    m_table->resizeColumnsToContents();
}

ColumnMapping ImportColumnsView::mapping() const
{
    ColumnMapping mapping;
    for (std::size_t i = 0; i < m_combos.size(); ++i)
        if (m_combos[i]->currentIndex() > 0)
            mapping.push_back({.field = kSightingFieldNames[i].value,
                               .column = m_combos[i]->currentData().toString().toStdString()});
    return mapping;
}

} // namespace berg

#include "widgets/panels/dialogs/import_columns_view.h"

#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/words/import_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kFields_px = 300;
constexpr int kMostColumn_px = 180;

/** Columns as the combos have them: by the names that are read, in the order of the file. */
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
    side->addWidget(scroll, 1);
    row->addLayout(side);
    m_table = newCellTable(m_rows, u"importHead"_s, tr("First rows of the file"));
    m_table->setSortingEnabled(false);
    m_table->horizontalHeader()->setMaximumSectionSize(kMostColumn_px);
    row->addWidget(m_table, 1);
    m_words->setVisible(false);
    clear();
}

void ImportColumnsView::clear()
{
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

#include "app/dialogs/import_rows_view.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ListWords
{
    const char* key;
    Rejections ImportResult::*rows;
    const char* name;
    const char* counted; ///< title; %1 is the number of rows
    const char* first;   ///< title of a cut list; %1 of %2 rows
};

const ListWords& wordsOf(ImportRowsView::List list)
{
    static constexpr std::array<ListWords, 3> kWords{{
        {"importRejected", &ImportResult::rejected,
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Rejected rows"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Rejected rows (%1)"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Rejected rows (first %1 of %2)")},
        {"importNoted", &ImportResult::noted,
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Changed rows"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Changed rows (%1)"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Changed rows (first %1 of %2)")},
        {"importOutside", &ImportResult::outside,
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Outside area or time"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Outside area or time (%1)"),
         QT_TRANSLATE_NOOP("berg::ImportRowsView", "Outside area or time (first %1 of %2)")},
    }};
    return kWords.at(static_cast<std::size_t>(list));
}

} // namespace

ImportRowsView::ImportRowsView(List list, QWidget* parent) : QWidget(parent), m_list(list)
{
    const ListWords& words = wordsOf(list);
    m_table = newCellTable(m_rows, QString::fromLatin1(words.key), tr(words.name));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_table);
    setFocusProxy(m_table);
}

void ImportRowsView::showPreview(const PreviewPointer& preview)
{
    const Rejections& rows = preview->result.*wordsOf(m_list).rows;
    m_count = rows.count;
    m_listed = rows.first.size();
    m_rows.setSheet(rowSheet(preview, wordsOf(m_list).rows, locale()));
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setStretchLastSection(true);
}

QString ImportRowsView::title() const
{
    const ListWords& words = wordsOf(m_list);
    return m_count == m_listed ? tr(words.counted).arg(m_count)
                               : tr(words.first).arg(m_listed).arg(m_count);
}

} // namespace berg

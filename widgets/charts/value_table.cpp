#include "widgets/charts/value_table.h"

#include <QAction>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kBest_px(560, 420);

void copy(const CellSheet& values)
{
    QString text;
    for (int row = -1; row < values.rows; ++row) {
        for (const CellColumn& column : values.columns)
            text += (row < 0 ? column.title : column.text(row)) + u'\t';
        text.back() = u'\n';
    }
    QGuiApplication::clipboard()->setText(text);
}

} // namespace

ValueTable::ValueTable(const QString& chart, const CellSheet& values, QWidget* parent)
    : QDialog(parent)
{
    setObjectName(u"valueTable"_s);
    setWindowTitle(tr("Values: %1").arg(chart));
    auto* column = new QVBoxLayout(this);
    auto* table = new QTableView;
    table->setObjectName(u"values"_s);
    table->setAccessibleName(chart);
    auto* model = new CellModel(table);
    model->setSheet(values);
    table->setModel(model);
    table->setTabKeyNavigation(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->verticalHeader()->hide();
    table->resizeColumnsToContents();
    column->addWidget(table);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    QPushButton* copies = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copies->setObjectName(u"copyValues"_s);
    connect(copies, &QPushButton::clicked, this, [values] { copy(values); });
    column->addWidget(buttons);
    resize(kBest_px);
    if (values.rows > 0)
        table->setCurrentIndex(table->model()->index(0, 0));
    table->setFocus();
}

void ValueTable::open(const QString& chart, const CellSheet& values, QWidget* parent)
{
    auto* table = new ValueTable(chart, values, parent);
    table->setAttribute(Qt::WA_DeleteOnClose);
    table->show();
}

QAction* addValueAction(QWidget& chart)
{
    auto* action = new QAction(ValueTable::tr("Show values as a table"), &chart);
    action->setShortcut(Qt::Key_V);
    action->setShortcutContext(Qt::WidgetShortcut);
    chart.addAction(action);
    return action;
}

} // namespace berg

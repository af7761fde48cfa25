#include "widgets/panels/dialogs/goto_bar.h"

#include "core/scenario/scenario.h"
#include "widgets/theme/quantity_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kEdge_px = 12;
constexpr int kWidth_px = 420;
constexpr double kRadius_px = 7;

} // namespace

GotoBar::GotoBar(QWidget* parent) : QWidget(parent)
{
    setObjectName(u"gotoBar"_s);
    setCursor(Qt::ArrowCursor);
    m_field = new PlaceField;
    m_field->setObjectName(u"gotoField"_s);
    auto* go = new QPushButton(tr("Go to"));
    go->setObjectName(u"gotoButton"_s);
    m_reason = new QLabel;
    m_reason->setObjectName(u"gotoReason"_s);
    m_reason->setWordWrap(true);
    m_move = new QPushButton(tr("Move the scenario here…"));
    m_move->setObjectName(u"gotoMoveButton"_s);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    row->addWidget(m_field, 1);
    row->addWidget(go);
    column->addLayout(row);
    column->addWidget(m_reason);
    column->addWidget(m_move, 0, Qt::AlignLeft);

    connect(m_field, &QLineEdit::returnPressed, this, &GotoBar::go);
    connect(m_field, &PlaceField::namePicked, this, &GotoBar::go);
    connect(m_field, &QLineEdit::textEdited, this, [this] { explain({}, false); });
    connect(go, &QPushButton::clicked, this, &GotoBar::go);
    connect(m_move, &QPushButton::clicked, this, [this] {
        dismiss();
        emit moveRequested(m_far);
    });
    parent->installEventFilter(this);
    hide();
}

void GotoBar::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void GotoBar::open(const LatLon& origin, bool mayMove)
{
    m_origin = origin;
    m_mayMove = mayMove;
    m_field->clear();
    explain({}, false);
    show();
    raise();
    m_field->setFocus(Qt::ShortcutFocusReason);
}

void GotoBar::go()
{
    if (!isVisible())
        return; // picked with Return, which has gone there already
    const auto found = m_field->found();
    if (const auto* reason = std::get_if<QString>(&found)) {
        explain(*reason, false);
        return;
    }
    const auto& target = std::get<FoundPlace>(found);
    if (!reachedPoint(target.at, m_origin)) {
        m_far = target.at;
        explain(beyondReachText(target.at, m_origin, locale()), m_mayMove);
        return;
    }
    dismiss();
    emit placeChosen(target.at, target.name);
}

void GotoBar::explain(const QString& reason, bool offersMove)
{
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    m_move->setVisible(offersMove);
    place();
}

void GotoBar::dismiss()
{
    emit closed(); // first: who takes the focus then is not given it as by the tabulator
    hide();
}

void GotoBar::place()
{
    const int width_px = std::min(kWidth_px, parentWidget()->width() - 2 * kEdge_px);
    layout()->activate();
    const int height_px = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width_px)
                                                        : sizeHint().height();
    setGeometry((parentWidget()->width() - width_px) / 2, kEdge_px, width_px, height_px);
}

void GotoBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.panelLine, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px, kRadius_px);
}

void GotoBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        dismiss();
    else
        QWidget::keyPressEvent(event);
    event->accept(); // never to the map below
}

bool GotoBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QWidget::eventFilter(watched, event);
}

} // namespace berg

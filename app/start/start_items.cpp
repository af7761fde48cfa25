#include "app/start/start_items.h"

#include <QDir>
#include <QFileInfo>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kEdge_px = 8;
constexpr double kRadius_px = 7;
constexpr int kTitle_px = 18;   ///< height of a line in bold
constexpr int kCaption_px = 16; ///< height of a line of small text

QString countText(int icebergs)
{
    return ExampleCard::tr("%n icebergs", nullptr, icebergs);
}

/** Returns the folder of a file, with "~" for the home folder. */
QString folderText(const QFileInfo& file)
{
    const QString folder = file.absolutePath();
    const QString home = QDir::homePath();
    const bool isAtHome = folder == home || folder.startsWith(home + u'/');
    return QDir::toNativeSeparators(isAtHome ? u'~' + folder.sliced(home.size()) : folder);
}

/** Ground and edge of something to be clicked. */
void paintGround(QPainter& painter, const QAbstractButton& button, const Theme& theme)
{
    const bool hovered = button.isEnabled() && button.underMouse();
    const bool focused = button.hasFocus();
    const QRectF rect = QRectF(button.rect()).adjusted(1, 1, -1, -1);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(focused ? theme.plan : theme.panelLine, focused ? 2 : 1));
    painter.setBrush(hovered || button.isDown() ? mixed(theme.chart, theme.plan, 0.12)
                                                : theme.chart);
    painter.drawRoundedRect(rect, kRadius_px, kRadius_px);
}

void paintLine(QPainter& painter, const QRect& rect, const QFont& font, const QColor& colour,
               const QString& text, Qt::TextElideMode elide = Qt::ElideRight)
{
    painter.setFont(font);
    painter.setPen(colour);
    painter.drawText(rect, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(font).elidedText(text, elide, rect.width()));
}

} // namespace

ExampleCard::ExampleCard(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setFixedSize(sizeHint());
}

void ExampleCard::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void ExampleCard::setExample(const Example& example)
{
    m_example = example;
    setText(example.title);
    setAccessibleName(example.title);
    setAccessibleDescription(example.notes);
    setToolTip(example.notes.isEmpty() ? QString()
                                       : u"<p>%1</p>"_s.arg(example.notes.toHtmlEscaped()));
    update();
}

QSize ExampleCard::sizeHint() const
{
    return kExampleImage_px + QSize(2, kTitle_px + kCaption_px + 2 * kEdge_px);
}

void ExampleCard::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintGround(painter, *this, m_theme);
    const QRect imageRect(QPoint(1, 1), kExampleImage_px);
    painter.save();
    QPainterPath outline;
    outline.addRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), kRadius_px - 1, kRadius_px - 1);
    painter.setClipPath(outline);
    if (m_example.image.isNull())
        painter.fillRect(imageRect, m_theme.sea);
    else
        painter.drawImage(imageRect, m_example.image);
    painter.restore();
    const QRect title(kEdge_px + 2, imageRect.bottom() + kEdge_px - 1, width() - 2 * kEdge_px - 4,
                      kTitle_px);
    paintLine(painter, title, m_theme.strong(), m_theme.text, text());
    if (m_example.icebergs > 0)
        paintLine(painter, title.translated(0, kTitle_px), m_theme.small(), m_theme.mutedText,
                  countText(m_example.icebergs));
}

RecentRow::RecentRow(const RecentFile& file, const Theme& theme, QWidget* parent)
    : QAbstractButton(parent), m_theme(theme), m_image(file.image)
{
    const QFileInfo info(file.path);
    setText(info.fileName());
    m_folder = folderText(info);
    setToolTip(QDir::toNativeSeparators(file.path));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    if (file.exists) {
        setCursor(Qt::PointingHandCursor);
        m_caption = QLocale().toString(file.changed, QLocale::ShortFormat);
        if (file.icebergs)
            m_caption += u" \u00b7 "_s + countText(*file.icebergs);
    } else {
        m_caption = tr("The file is gone");
        m_remove = new QToolButton(this);
        m_remove->setObjectName(u"removeRecentButton"_s);
        m_remove->setText(tr("Remove"));
        m_remove->setToolTip(tr("Remove it from this list."));
        connect(m_remove, &QToolButton::clicked, this, &RecentRow::removeRequested);
        setFocusPolicy(Qt::NoFocus); // there is nothing to open
    }
    setAccessibleName(text());
    setAccessibleDescription(m_folder + u", "_s + m_caption);
}

QSize RecentRow::sizeHint() const
{
    return {200, kRecentImage_px.height() + kEdge_px};
}

void RecentRow::resizeEvent(QResizeEvent* event)
{
    QAbstractButton::resizeEvent(event);
    if (m_remove == nullptr)
        return;
    const QSize size = m_remove->sizeHint();
    m_remove->setGeometry(width() - size.width() - kEdge_px, (height() - size.height()) / 2,
                          size.width(), size.height());
}

void RecentRow::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    const bool gone = m_remove != nullptr;
    if (!gone)
        paintGround(painter, *this, m_theme);
    const QRect imageRect(QPoint(kEdge_px / 2, kEdge_px / 2), kRecentImage_px);
    if (!m_image.isNull())
        painter.drawImage(imageRect, m_image);
    else if (!gone)
        painter.fillRect(imageRect, m_theme.sea);
    const int left = imageRect.right() + kEdge_px;
    const int right = gone ? m_remove->width() + kEdge_px : kEdge_px;
    QRect line(left, (height() - kTitle_px - 2 * kCaption_px) / 2, width() - left - right,
               kTitle_px);
    paintLine(painter, line, m_theme.strong(), gone ? m_theme.mutedText : m_theme.text, text(),
              Qt::ElideMiddle);
    line.translate(0, kTitle_px);
    paintLine(painter, line, m_theme.small(), m_theme.mutedText, m_folder, Qt::ElideMiddle);
    line.translate(0, kCaption_px);
    paintLine(painter, line, m_theme.small(), m_theme.mutedText, m_caption);
}

} // namespace berg

#include "widgets/print/brief_layout.h"

#include "widgets/print/brief_setting.h"
#include "widgets/print/brief_table_layout.h"
#include "widgets/print/brief_uav_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct FlightBrief
{
    Q_DECLARE_TR_FUNCTIONS(FlightBrief)
};

constexpr BriefType kTitle{.size_px = 20, .isBold = true};
constexpr BriefType kHead{.size_px = 12};
constexpr BriefType kCaption{.size_px = 10, .isMuted = true};
constexpr BriefType kFact{.size_px = 12, .isBold = true};
constexpr BriefType kHeading{.size_px = 11, .isBold = true};
constexpr BriefType kWords{.size_px = 10};
constexpr BriefType kFoot{.size_px = 9, .isMuted = true};

constexpr double kBlockGap_px = 10;
constexpr double kTextGap_px = 12; // between texts of one line
constexpr int kFactColumns = 12;
constexpr int kLinesOfWarning = 2;

BriefType right(BriefType type)
{
    type.isRight = true;
    return type;
}

/** How much room the parts take from each other, the most generous first. */
struct BriefShares
{
    int warningLines = 0;
    int noteLines = 0;
    double map_px = 0; ///< least height
};
constexpr std::array<BriefShares, 3> kShares{{{10, 5, 360}, {7, 3, 300}, {5, 1, 240}}};

constexpr std::array<BriefTableStyle, 5> kTableStyles{
    {{12, 1}, {11, 1}, {10, 1}, {10, 2}, {kSmallestBriefType_px, 2}}};

/** Sets one block after the other from the top of the page. */
class Page
{
public:
    Page(const BriefContent& content, const QSizeF& page) : m_content(content)
    {
        m_layout.page = page;
        m_free =
            QRectF(QPointF(0, 0), page)
                .adjusted(kBriefMargin_px, kBriefMargin_px, -kBriefMargin_px, -kBriefMargin_px);
    }

    BriefLayout laidOut()
    {
        setHead();
        setFacts(m_content.flight);
        setFacts(m_content.planning);
        taken(4);
        setUavs();
        setFoot();
        setBody();
        return std::move(m_layout);
    }

private:
    /** A strip of this height from the top of what is free. */
    QRectF taken(double height_px)
    {
        const QRectF strip(m_free.left(), m_free.top(), m_free.width(), height_px);
        m_free.setTop(strip.bottom());
        return strip;
    }

    void rule(double y, bool isStrong)
    {
        m_layout.rules.push_back({QLineF(m_free.left(), y, m_free.right(), y), isStrong});
    }

    /** Two texts of one line; the second keeps its width. */
    void setPair(const QRectF& strip, const QString& first, const BriefType& firstType,
                 const QString& second, const BriefType& secondType)
    {
        const double second_px =
            std::min(std::ceil(widthOf_px(second, secondType)) + 1, 0.6 * strip.width());
        setText(m_layout, strip.adjusted(0, 0, -second_px - kTextGap_px, 0), first, firstType);
        setText(m_layout, strip.adjusted(strip.width() - second_px, 0, 0, 0), second,
                right(secondType));
    }

    void setHead()
    {
        setPair(taken(linePitch_px(kTitle.size_px)), m_content.title, kTitle, u"Bergwatch"_s,
                kCaption);
        setPair(taken(linePitch_px(kHead.size_px)),
                u"%1 · %2"_s.arg(FlightBrief::tr("Flight brief: %1").arg(m_content.about),
                                 m_content.origin),
                kHead, m_content.start, {.size_px = kHead.size_px, .isBold = true});
        rule(taken(4).bottom(), true);
        taken(5);
    }

    /** In columns, each fact as many of them wide as it needs. */
    void setFacts(const std::vector<BriefFact>& facts)
    {
        const double column_px = m_free.width() / kFactColumns;
        const double caption_px = linePitch_px(kCaption.size_px);
        const double height_px = caption_px + linePitch_px(kFact.size_px);
        int at = kFactColumns;
        QRectF row;
        for (const BriefFact& fact : facts) {
            const double wide_px =
                std::max(widthOf_px(fact.caption, kCaption), widthOf_px(fact.value, kFact)) +
                kTextGap_px;
            const int span =
                std::clamp(static_cast<int>(std::ceil(wide_px / column_px)), 1, kFactColumns);
            if (at + span > kFactColumns) {
                row = taken(height_px + 3).adjusted(0, 0, 0, -3);
                at = 0;
            }
            const QRectF box(row.left() + at * column_px, row.top(), span * column_px - kTextGap_px,
                             height_px);
            setText(m_layout, box.adjusted(0, 0, 0, caption_px - height_px), fact.caption,
                    kCaption);
            setText(m_layout, box.adjusted(0, caption_px, 0, 0), fact.value, kFact);
            at += span;
        }
    }

    void setUavs()
    {
        rule(m_free.top(), false);
        taken(3);
        m_free.setTop(setUavTable(m_layout, m_content.uavs, m_free));
        if (!m_content.sorties.empty())
            m_free.setTop(setUavTable(m_layout, m_content.sorties, m_free));
        taken(6);
    }

    void setFoot()
    {
        const double height_px = linePitch_px(kFoot.size_px);
        const QRectF strip(m_free.left(), m_free.bottom() - height_px, m_free.width(), height_px);
        m_free.setBottom(strip.top() - 3);
        rule(m_free.bottom(), false);
        setText(m_layout, strip, m_content.foot, kFoot);
    }

    [[nodiscard]] QStringList warningLines(int most) const
    {
        QStringList lines;
        for (qsizetype i = 0; i < m_content.warnings.size(); ++i) {
            const QStringList more =
                wrapped(u"– "_s + m_content.warnings[i], kWords, m_free.width(), kLinesOfWarning);
            const qsizetype left = m_content.warnings.size() - i;
            // The last line is needed to say that there are more.
            if (lines.size() + more.size() > most - (left > 1 ? 1 : 0)) {
                lines << FlightBrief::tr("and %1 more").arg(left);
                break;
            }
            lines << more;
        }
        return lines;
    }

    [[nodiscard]] static double heightOf_px(const QStringList& lines)
    {
        return lines.isEmpty()
                   ? 0
                   : linePitch_px(kHeading.size_px) + kBlockGap_px +
                         static_cast<double>(lines.size()) * linePitch_px(kWords.size_px);
    }

    void setLines(const QString& heading, const QStringList& lines)
    {
        if (lines.isEmpty())
            return;
        taken(kBlockGap_px);
        setText(m_layout, taken(linePitch_px(kHeading.size_px)), heading, kHeading);
        for (const QString& line : lines)
            setText(m_layout, taken(linePitch_px(kWords.size_px)), line, kWords);
    }

    [[nodiscard]] QStringList noteLines(int most) const
    {
        return m_content.notes.isEmpty() ? QStringList()
                                         : wrapped(m_content.notes, kWords, m_free.width(), most);
    }

    /** Height that the words below the table take. */
    [[nodiscard]] double words_px(const BriefShares& shares) const
    {
        const QStringList warnings = warningLines(shares.warningLines);
        return (warnings.isEmpty() ? kBlockGap_px + linePitch_px(kHeading.size_px)
                                   : heightOf_px(warnings)) +
               heightOf_px(noteLines(shares.noteLines)) + kBlockGap_px;
    }

    /** What is left for the table. */
    [[nodiscard]] QSizeF tableRoom(const BriefShares& shares) const
    {
        return {m_free.width(), m_free.height() - words_px(shares) - shares.map_px - kBlockGap_px};
    }

    /** Map, table and words: the first way of sharing that holds the whole table, or the last. */
    void setBody()
    {
        const BriefTable table(m_content);
        for (const BriefShares& shares : kShares)
            for (const BriefTableStyle& style : kTableStyles)
                if (table.fitsInto(tableRoom(shares), style))
                    return setBody(table, style, shares);
        setBody(table, kTableStyles.back(), kShares.back());
    }

    void setBody(const BriefTable& table, const BriefTableStyle& style, const BriefShares& shares)
    {
        const double table_px = table.heightIn_px(tableRoom(shares).height(), style);
        m_layout.map = taken(m_free.height() - words_px(shares) - table_px - kBlockGap_px);
        taken(kBlockGap_px);
        table.setInto(m_layout, taken(table_px), style);
        const QStringList warnings = warningLines(shares.warningLines);
        if (warnings.isEmpty()) {
            taken(kBlockGap_px);
            setText(m_layout, taken(linePitch_px(kHeading.size_px)), FlightBrief::tr("No warnings"),
                    kHeading);
        }
        setLines(FlightBrief::tr("Warnings (%1)").arg(m_content.warnings.size()), warnings);
        setLines(FlightBrief::tr("Notes"), noteLines(shares.noteLines));
    }

    const BriefContent& m_content;
    BriefLayout m_layout;
    QRectF m_free;
};

} // namespace

BriefLayout layOutBrief(const BriefContent& content, const QSizeF& page)
{
    return Page(content, page).laidOut();
}

} // namespace berg

#pragma once

#include <QAbstractTextDocumentLayout>
#include <QFont>
#include <QSize>
#include <QString>
#include <QTextDocument>

#include <functional>
#include <map>
#include <string>

#ifdef Q_MOC_RUN // moc reads no other header
Q_DECLARE_INTERFACE(QTextObjectInterface, "org.qt-project.Qt.QTextObjectInterface")
#endif

namespace berg {

/** Distance from the paper's edges: 12.7 mm. */
inline constexpr double kPaperMargin_px = 48;
/** Font size of text and tables: 8.25 pt. */
inline constexpr int kPrint_px = 11;

/** HTML on paper, in the subset of QTextDocument. */
struct PrintedDocument
{
    QSize paper_px; ///< at 96 per inch
    std::string html{};
    /** Pictures by the `src` of an img element with width and height; each is painted into a
     * rectangle of that size at the origin. */
    std::map<QString, std::function<void(QPainter&)>> pictures{};

    /** Returns the size between the margins. */
    [[nodiscard]] QSizeF room_px() const
    {
        return QSizeF(paper_px) - 2 * QSizeF(kPaperMargin_px, kPaperMargin_px);
    }
};

/** A document laid out on pages. Belongs to the thread that made it. */
class PrintedText : public QTextDocument, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    /** Lays out the document, which must outlive this. */
    explicit PrintedText(const PrintedDocument& document);

    /** Returns the height that is left on the only page, or less than 0. */
    [[nodiscard]] double spare_px() const;
    /** Paints the page of this number, from zero. */
    void paintPage(QPainter& painter, int page) const;

    QSizeF intrinsicSize(QTextDocument* text, int at, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* text, int at,
                    const QTextFormat& format) override;

private:
    const PrintedDocument& m_document;
};

/** Returns the font of printed text. It has no hinting, so that texts are equally wide on every
 * device and at every size. */
[[nodiscard]] QFont printFont(int size_px);
/** Returns the width of a text in that font. */
[[nodiscard]] double printWidth_px(const QString& text, int size_px = kPrint_px);
/** Returns the text as HTML, elided if it is wider. */
[[nodiscard]] std::string htmlWithin(const QString& text, double width_px, int size_px = kPrint_px);
/** Returns the text as HTML. */
[[nodiscard]] std::string html(const QString& text);
/** Returns the element of the picture `name`. */
[[nodiscard]] std::string pictureHtml(const std::string& name, const QSizeF& size_px);

} // namespace berg

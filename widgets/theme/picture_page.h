#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include <array>
#include <functional>
#include <string>
#include <vector>

class QPainter;

namespace berg {

/** Ends of the names of picture files. */
inline constexpr std::array kPictureEndings = {"png", "svg", "pdf"};

/** A picture on a page of its own. */
struct PicturePage
{
    QSize size_px; ///< of the layout, at 96 to the inch; PNG has twice as many
    QString title;
    QString description;
    std::function<void(QPainter&)> paint;                  ///< within `size_px`, on white
    std::vector<std::function<void(QPainter&)>> more = {}; ///< further pages, in a PDF alone
};

/** Pages of one size. */
struct PdfPages
{
    QSize size_px; ///< of the layout, at 96 to the inch
    QString title;
    int count = 0;
    std::function<void(QPainter&, int)> paint; ///< the page of that number, from 0
};

/** The pages as a PDF; the same pages, the same bytes. */
[[nodiscard]] std::string pdfFile(const PdfPages& pages);

/** `scale` pixels for each of the layout. */
[[nodiscard]] QImage pictureImage(const PicturePage& page, double scale);

/** The picture as a file of one of `kPictureEndings`; the same page, the same bytes. */
[[nodiscard]] std::string pictureFile(const PicturePage& page, const QString& ending);

/**
 * Writes the picture that the end of `path` names. Throws `Error`: Unsupported for another end than
 * `kPictureEndings`, FileUnwritable.
 */
void writePicture(const PicturePage& page, const QString& path);

} // namespace berg

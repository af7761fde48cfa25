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

/** File name extensions of picture formats. */
inline constexpr std::array kPictureEndings = {"png", "svg", "pdf"};

/** A picture on a page of its own. */
struct PicturePage
{
    QSize size_px; ///< layout size at 96 per inch; PNG has twice as many pixels
    QString title;
    QString description;
    std::function<void(QPainter&)> paint;                  ///< paints within `size_px`, on white
    std::vector<std::function<void(QPainter&)>> more = {}; ///< further pages, in PDF only
};

/** Pages of equal size. */
struct PdfPages
{
    QSize size_px; ///< layout size at 96 per inch
    QString title;
    int count = 0;
    std::function<void(QPainter&, int)> paint; ///< paints the page of this number, from zero
};

/** Renders pages to PDF; equal pages give equal bytes. */
[[nodiscard]] std::string pdfFile(const PdfPages& pages);

/** Renders the picture to an image with `scale` pixels per layout unit. */
[[nodiscard]] QImage pictureImage(const PicturePage& page, double scale);

/** Renders the picture to one of `kPictureEndings`; equal pages give equal bytes. */
[[nodiscard]] std::string pictureFile(const PicturePage& page, const QString& ending);

/**
 * Writes the picture to `path` in the format given by its extension. Throws `Error`: Unsupported
 * for an extension other than `kPictureEndings`, FileUnwritable.
 */
void writePicture(const PicturePage& page, const QString& path);

} // namespace berg

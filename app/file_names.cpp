#include "app/file_names.h"

#include "app/main_window.h"

#include <QFileInfo>
#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace berg {

QString fileNameOf(const QString& name)
{
    static const QRegularExpression kForbidden(u"[/\\\\:*?\"<>|\\x00-\\x1f]+"_s);
    const QString clean = QString(name).replace(kForbidden, u"-"_s).simplified();
    return clean.isEmpty() || clean.startsWith(u'.') ? MainWindow::tr("Untitled") + clean : clean;
}

QString withExtension(const QString& path, const QString& extension)
{
    return QFileInfo(path).suffix().isEmpty() ? path + u'.' + extension : path;
}

} // namespace berg

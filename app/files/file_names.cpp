#include "app/files/file_names.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

struct FileNames
{
    Q_DECLARE_TR_FUNCTIONS(FileNames)
};

} // namespace

QString fileNameOf(const QString& name)
{
    static const QRegularExpression kForbidden(u"[/\\\\:*?\"<>|\\x00-\\x1f]+"_s);
    const QString clean = QString(name).replace(kForbidden, u"-"_s).simplified();
    return clean.isEmpty() || clean.startsWith(u'.') ? FileNames::tr("Untitled") + clean : clean;
}

QString withExtension(const QString& path, const QString& extension)
{
    return QFileInfo(path).suffix().isEmpty() ? path + u'.' + extension : path;
}

} // namespace berg

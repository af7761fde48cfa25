#include "widgets/theme/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace berg {

using namespace Qt::StringLiterals;

void installLanguage(const QString& language)
{
    static QTranslator own;
    static QTranslator qt;
    QCoreApplication::removeTranslator(&own);
    QCoreApplication::removeTranslator(&qt);
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    for (const QLocale& spoken : {locale, QLocale(QLocale::English)})
        if (own.load(spoken, u"bergwatch"_s, u"_"_s, u":/i18n"_s)) {
            QCoreApplication::installTranslator(&own);
            break;
        }
    if (qt.load(locale, u"qt"_s, u"_"_s, u":/i18n"_s) ||
        qt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt);
}

} // namespace berg

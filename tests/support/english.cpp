// Part of every test program that shows texts: it uses English, with its plural forms, on every
// machine.
#include "widgets/theme/language.h"

#include <QCoreApplication>
#include <QLocale>

namespace {

void speakEnglish()
{
    berg::installLanguage(QStringLiteral("en"));
    QLocale::setDefault(QLocale::system()); // number formats do not change
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(speakEnglish)

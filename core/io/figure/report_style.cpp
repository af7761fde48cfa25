#include "core/io/figure/report_style.h"

#include "core/io/text/html_text.h"

namespace berg {

std::string reportHead(const ReportHead& head, const std::string& style)
{
    // The policy lets nothing be loaded and nothing be run, whatever else the page may hold.
    return "<!DOCTYPE html>\n"
           "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"" +
           htmlText(head.language) +
           "\">\n<head>\n"
           "<meta charset=\"utf-8\"/>\n"
           "<meta http-equiv=\"Content-Security-Policy\" "
           "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"" +
           htmlText(head.program) + "\"/>\n<title>" + htmlText(head.title) + "</title>\n<style>" +
           std::string(kReportStyle) + style + "</style>\n</head>\n";
}

} // namespace berg

#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QString>
#include <optional>

namespace hexoderm {

// How figures and things are written in tables and tooltips: degrees and millimetres, in the user's locale, an en dash
// for what is not known.

QString noValue();
/// No line breaks between a figure and its unit.
QString unbroken(QString text);
QString lotWords(const LotEstimate& lot);  ///< lotText() in the program's language, with real signs
/// With a real minus sign, and none before a zero.
QString figureText(double value, int decimals);
QString degreesText(std::optional<double> angle_rad);
QString wholeDegreesText(double angle_rad);
/// "12.35 mm".
QString millimetresText(double length_m, int decimals);
/// "no poses", "1 pose", "4 poses".
QString posesText(std::size_t count);
/// "5:2 – 9:3", cell and port of both ends, as on the command line.
QString shortLinkName(LinkEnd a, LinkEnd b);
inline QString shortLinkName(const LinkEstimate& link) { return shortLinkName(link.source, link.target); }
/// "Link 5 · port 2 — 9 · port 3".
QString longLinkName(const LinkEstimate& link);
/// Why a link is excluded, one sentence; empty if it is not.
QString excludedBecause(const LinkEstimate& link);

QString severityWord(Severity severity);
/// "cells 5, 9; pose 3"; an en dash if the finding is about the whole skin.
QString placeText(const Finding& finding);

/// The finding's words on why a link is not used; its code's where there is none.
QString excludedBecause(const Reconstruction& reconstruction, const LinkEstimate& link);

/// Several lines for a tooltip (rich text). Those of links and cells have every figure that is known.
QString linkToolTip(const Reconstruction& reconstruction, const LinkEstimate& link);
QString findingToolTip(const Finding& finding);
QString cellToolTip(const Reconstruction& reconstruction, CellId cell);

}  // namespace hexoderm

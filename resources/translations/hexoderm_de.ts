<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>hexoderm::Banner</name>
    <message>
        <source>Where we stand</source>
        <translation>Wo wir stehen</translation>
    </message>
</context>
<context>
    <name>hexoderm::CapturePanel</name>
    <message>
        <source>Capturing poses</source>
        <translation>Posen aufnehmen</translation>
    </message>
    <message>
        <source>No skin is connected, so no pose can be taken.</source>
        <translation>Keine Haut ist verbunden, also lässt sich keine Pose aufnehmen.</translation>
    </message>
    <message>
        <source>no readings</source>
        <translation>keine Messwerte</translation>
    </message>
    <message>
        <source>Captured</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>No skin is connected.</source>
        <translation>Keine Haut ist verbunden.</translation>
    </message>
    <message>
        <source>Working out which pose helps most…</source>
        <translation>Gesucht wird, welche Pose am meisten hilft…</translation>
    </message>
    <message>
        <source>Keep turning</source>
        <translation>Weiterdrehen</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Wird geschrieben</translation>
    </message>
    <message>
        <source>Pose %1 captured.</source>
        <translation>Pose %1 aufgenommen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::CapturePresenter</name>
    <message>
        <source>It repeats pose %1.</source>
        <translation>Sie wiederholt Pose %1.</translation>
    </message>
</context>
<context>
    <name>hexoderm::CaptureWords</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mg</source>
        <translation>%1 mg</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>reads no gravity</source>
        <translation>misst keine Schwerkraft</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>hängt</translation>
    </message>
    <message>
        <source>noisy</source>
        <translation>rauscht</translation>
    </message>
    <message>
        <source>turns by itself</source>
        <translation>dreht sich allein</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>Hold the part still, any way up.</source>
        <translation>Das Teil stillhalten, egal wie herum.</translation>
    </message>
    <message>
        <source>There are enough poses. Another one would hardly help.</source>
        <translation>Es sind genug Posen. Eine weitere würde kaum helfen.</translation>
    </message>
    <message>
        <source>Turn the part so that cell %1 faces the ceiling.</source>
        <translation>Das Teil so drehen, dass Zelle %1 zur Decke zeigt.</translation>
    </message>
    <message>
        <source>Turn the part so that cell %1 faces the floor.</source>
        <translation>Das Teil so drehen, dass Zelle %1 zum Boden zeigt.</translation>
    </message>
    <message>
        <source>Turn the part so that cell %1 faces a wall, as the picture shows.</source>
        <translation>Das Teil so drehen, dass Zelle %1 zur Wand zeigt, wie im Bild.</translation>
    </message>
    <message>
        <source>It is there: hold it like this.</source>
        <translation>Geschafft: So halten.</translation>
    </message>
    <message>
        <source>Half a turn around a horizontal axis.</source>
        <translation>Eine halbe Drehung um eine waagrechte Achse.</translation>
    </message>
    <message>
        <source>About %1° around the horizontal axis shown.</source>
        <translation>Etwa %1° um die gezeigte waagrechte Achse.</translation>
    </message>
    <message>
        <source>Why: gravity, as every cell feels it, tells how the cells are turned against each other.</source>
        <translation>Warum: Die Schwerkraft, wie jede Zelle sie spürt, verrät, wie die Zellen gegeneinander gedreht sind.</translation>
    </message>
    <message>
        <source>Why: gravity has been seen along one line only. A second direction tells how the cells are turned about it.</source>
        <translation>Warum: Die Schwerkraft wurde nur entlang einer Linie gesehen. Eine zweite Richtung verrät, wie die Zellen um sie gedreht sind.</translation>
    </message>
    <message>
        <source>Why: the opposite of pose %1 tells each sensor&apos;s offset from its scale.</source>
        <translation>Warum: Das Gegenteil von Pose %1 trennt Nullpunkt und Skalierung jedes Sensors.</translation>
    </message>
    <message>
        <source>Why: a further direction averages out what the sensors still get wrong.</source>
        <translation>Warum: Eine weitere Richtung mittelt aus, was die Sensoren noch falsch messen.</translation>
    </message>
    <message>
        <source>No direction is missing: all three values reach %1.</source>
        <translation>Keine Richtung fehlt: Alle drei Werte erreichen %1.</translation>
    </message>
    <message>
        <source>No pose yet: any direction will do.</source>
        <translation>Noch keine Pose: Jede Richtung ist recht.</translation>
    </message>
    <message>
        <source>No pose yet with cell %1 facing the ceiling or the floor: the second value is %2, needs %3.</source>
        <translation>Noch keine Pose mit Zelle %1 zur Decke oder zum Boden: Der zweite Wert ist %2, nötig sind %3.</translation>
    </message>
    <message>
        <source>No pose yet with cell %1 facing the ceiling or the floor: the third value is %2, needs %3.</source>
        <translation>Noch keine Pose mit Zelle %1 zur Decke oder zum Boden: Der dritte Wert ist %2, nötig sind %3.</translation>
    </message>
    <message>
        <source>%1, %2 disabled</source>
        <translation>%1, %2 nicht benutzt</translation>
    </message>
    <message>
        <source>pose %1 on the front</source>
        <translation>Pose %1 vorn</translation>
    </message>
    <message>
        <source>pose %1 on the back</source>
        <translation>Pose %1 hinten</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1, nicht benutzt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Capturing…</source>
        <translation>Aufnahme…</translation>
    </message>
    <message>
        <source>Hold…</source>
        <translation>Halten…</translation>
    </message>
    <message>
        <source>Still</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>ready to capture</source>
        <translation>bereit zur Aufnahme</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>then hold it still</source>
        <translation>dann stillhalten</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Stillhalten</translation>
    </message>
    <message>
        <source>waits for stillness</source>
        <translation>wartet auf Ruhe</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>for readings</source>
        <translation>auf Messwerte</translation>
    </message>
    <message>
        <source>Looking whether it stayed still…</source>
        <translation>Prüft, ob es ruhig blieb…</translation>
    </message>
    <message>
        <source>Taking readings as they are, moved or not</source>
        <translation>Misst, was da ist, bewegt oder nicht</translation>
    </message>
    <message>
        <source>Taking readings of %1 cells</source>
        <translation>Misst %1 Zellen</translation>
    </message>
    <message>
        <source>The part is still</source>
        <translation>Das Teil ist ruhig</translation>
    </message>
    <message>
        <source>Waiting: no cell sends readings</source>
        <translation>Wartet: Keine Zelle sendet Messwerte</translation>
    </message>
    <message>
        <source>Waiting: %1 s of readings are needed to judge</source>
        <translation>Wartet: Zum Beurteilen braucht es Messwerte von %1 s</translation>
    </message>
    <message>
        <source>Waiting: moved %1 since the last pose, needs %2</source>
        <translation>Wartet: seit der letzten Pose %1 bewegt, nötig sind %2</translation>
    </message>
    <message>
        <source>Waiting: the part turns by %1, limit %2</source>
        <translation>Wartet: Das Teil dreht sich mit %1, Grenze %2</translation>
    </message>
    <message>
        <source>Waiting: cell %1 moves %2, limit %3</source>
        <translation>Wartet: Zelle %1 bewegt sich um %2, Grenze %3</translation>
    </message>
    <message>
        <source>Waiting: cell %1 turns by %2 against the rest, limit %3</source>
        <translation>Wartet: Zelle %1 dreht sich mit %2 gegen die anderen, Grenze %3</translation>
    </message>
    <message>
        <source>cell %1 (%2)</source>
        <translation>Zelle %1 (%2)</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Not waited for: %1</source>
        <translation>Nicht gewartet wird auf: %1</translation>
    </message>
    <message>
        <source>Another pose would hardly make it better.</source>
        <translation>Eine weitere Pose würde kaum etwas verbessern.</translation>
    </message>
    <message>
        <source>With this pose the error falls to about %1 % of what it is now.</source>
        <translation>Mit dieser Pose sinkt der Fehler auf etwa %1 % des jetzigen.</translation>
    </message>
    <message>
        <source>No pose yet with the side of cell %1 up or down: the second value is %2, needs %3.</source>
        <translation>Noch keine Pose, in der die Seite von Zelle %1 nach oben oder unten zeigt: Der zweite Wert ist %2, nötig sind %3.</translation>
    </message>
    <message>
        <source>No pose yet with the side of cell %1 up or down: the third value is %2, needs %3.</source>
        <translation>Noch keine Pose, in der die Seite von Zelle %1 nach oben oder unten zeigt: Der dritte Wert ist %2, nötig sind %3.</translation>
    </message>
    <message>
        <source>Why: two directions can&apos;t tell a cell&apos;s turn from its sensor&apos;s offset. A third one, far from both, can.</source>
        <translation>Warum: Zwei Richtungen unterscheiden die Drehung einer Zelle nicht vom Nullpunktfehler ihres Sensors. Eine dritte, weit von beiden, kann es.</translation>
    </message>
    <message>
        <source>Why: the error that is left does not come from too few directions.</source>
        <translation>Warum: Der Fehler, der bleibt, kommt nicht von zu wenigen Richtungen.</translation>
    </message>
    <message>
        <source>A second direction is missing (value %1, needs %2); the next pose is one.</source>
        <translation>Eine zweite Richtung fehlt (Wert %1, nötig sind %2); die nächste Pose ist eine.</translation>
    </message>
    <message>
        <source>A third direction is missing (value %1, needs %2); the next pose is one.</source>
        <translation>Eine dritte Richtung fehlt (Wert %1, nötig sind %2); die nächste Pose ist eine.</translation>
    </message>
    <message>
        <source>The part is still. Automatic capture is off</source>
        <translation>Das Teil ist ruhig. Die Automatik ist aus</translation>
    </message>
    <message>
        <source>There are enough poses: the result is good.</source>
        <translation>Es sind genug Posen: Das Ergebnis ist gut.</translation>
    </message>
    <message>
        <source>Why: at the worst cell the error is below %1° and %2 mm.</source>
        <translation>Warum: An der schlechtesten Zelle liegt der Fehler unter %1° und %2 mm.</translation>
    </message>
    <message>
        <source>With another pose the error would fall to about %1 % of what it is now.</source>
        <translation>Mit einer weiteren Pose fiele der Fehler auf etwa %1 % des jetzigen.</translation>
    </message>
    <message>
        <source>values %1, %2 and %3, of which %4 is enough: %5</source>
        <translation>Werte %1, %2 und %3, von denen %4 genügt: %5</translation>
    </message>
    <message>
        <source>A second direction is not seen yet: its value is %1, of %2.</source>
        <translation>Eine zweite Richtung ist noch nicht gesehen: Ihr Wert ist %1 von %2.</translation>
    </message>
    <message>
        <source>A third direction is not seen yet: its value is %1, of %2.</source>
        <translation>Eine dritte Richtung ist noch nicht gesehen: Ihr Wert ist %1 von %2.</translation>
    </message>
    <message>
        <source>The result does not need all three values to reach %1.</source>
        <translation>Für das Ergebnis müssen nicht alle drei Werte %1 erreichen.</translation>
    </message>
    <message>
        <source>There are enough poses. With another one the error would fall to about %1 % of what it is now.</source>
        <translation>Es sind genug Posen. Mit einer weiteren fiele der Fehler auf etwa %1 % des jetzigen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::CardDock</name>
    <message>
        <source>Drag to move this panel, double-click to take it out of the window</source>
        <translation>Ziehen verschiebt dieses Feld, Doppelklick löst es aus dem Fenster</translation>
    </message>
</context>
<context>
    <name>hexoderm::CellTableModel</name>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>Orientation in the patch&apos;s frame: roll, pitch and yaw with R = Rz Ry Rx, degrees</source>
        <translation>Orientierung im Koordinatensystem des Hautstücks: Rollen, Nicken und Gieren mit R = Rz Ry Rx, Grad</translation>
    </message>
    <message>
        <source>Position in the patch&apos;s frame, which is its origin cell&apos;s</source>
        <translation>Ort im Koordinatensystem des Hautstücks, dem seiner Ursprungszelle</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>ID of the cell</source>
        <translation>ID der Zelle</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>Cells joined by rigid links make a patch; each has a frame of its own</source>
        <translation>Starr verbundene Zellen bilden ein Hautstück; jedes hat sein eigenes Koordinatensystem</translation>
    </message>
    <message>
        <source>X mm</source>
        <translation>X mm</translation>
    </message>
    <message>
        <source>Y mm</source>
        <translation>Y mm</translation>
    </message>
    <message>
        <source>Z mm</source>
        <translation>Z mm</translation>
    </message>
    <message>
        <source>Roll °</source>
        <translation>Rollen °</translation>
    </message>
    <message>
        <source>Pitch °</source>
        <translation>Nicken °</translation>
    </message>
    <message>
        <source>Yaw °</source>
        <translation>Gieren °</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Where the cell is with 95 %, relative to the origin, along the worst direction</source>
        <translation>Wo die Zelle mit 95 % ist, bezogen auf den Ursprung, entlang der schlechtesten Richtung</translation>
    </message>
    <message>
        <source>± °</source>
        <translation>± °</translation>
    </message>
    <message>
        <source>How the cell lies with 95 %, relative to the origin, about the worst axis</source>
        <translation>Wie die Zelle mit 95 % liegt, bezogen auf den Ursprung, um die schlechteste Achse</translation>
    </message>
    <message>
        <source>Placed by</source>
        <translation>Eingeordnet durch</translation>
    </message>
    <message>
        <source>Whether the cell&apos;s own readings place it, or only its links</source>
        <translation>Ob eigene Messwerte die Zelle einordnen oder nur ihre Verbindungen</translation>
    </message>
    <message>
        <source>Worst residual °</source>
        <translation>Größter Restfehler °</translation>
    </message>
    <message>
        <source>The largest residual of its links: rms over the poses</source>
        <translation>Der größte Restfehler ihrer Verbindungen: Effektivwert über die Posen</translation>
    </message>
    <message>
        <source>Offset mg</source>
        <translation>Nullpunkt mg</translation>
    </message>
    <message>
        <source>Estimated offset of the accelerometer: length of the vector</source>
        <translation>Geschätzter Nullpunkt des Sensors: Länge des Vektors</translation>
    </message>
    <message>
        <source>Scale %</source>
        <translation>Skalierung %</translation>
    </message>
    <message>
        <source>Estimated error of the accelerometer&apos;s scale: worst axis</source>
        <translation>Geschätzter Fehler der Skalierung des Sensors: schlechteste Achse</translation>
    </message>
</context>
<context>
    <name>hexoderm::CheckList</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>needs a look</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::Coloring</name>
    <message>
        <source>link quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>residual, rms over poses</source>
        <translation>Restfehler, Effektivwert über die Posen</translation>
    </message>
    <message>
        <source>worst link&apos;s residual</source>
        <translation>Restfehler der schlechtesten Verbindung</translation>
    </message>
    <message>
        <source>No link was measured yet</source>
        <translation>Noch ist keine Verbindung gemessen</translation>
    </message>
    <message>
        <source>predicted deviation</source>
        <translation>erwartete Abweichung</translation>
    </message>
    <message>
        <source>worst link&apos;s predicted deviation</source>
        <translation>erwartete Abweichung der schlechtesten Verbindung</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>Verwindung</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>yaw, either way</source>
        <translation>Gieren, beide Richtungen</translation>
    </message>
    <message>
        <source>position uncertainty</source>
        <translation>Unsicherheit des Ortes</translation>
    </message>
    <message>
        <source>position uncertainty (95 %)</source>
        <translation>Unsicherheit des Ortes (95 %)</translation>
    </message>
    <message>
        <source>This result states no uncertainties</source>
        <translation>Dieses Ergebnis nennt keine Unsicherheiten</translation>
    </message>
    <message>
        <source>orientation uncertainty</source>
        <translation>Unsicherheit der Orientierung</translation>
    </message>
    <message>
        <source>orientation uncertainty (95 %)</source>
        <translation>Unsicherheit der Orientierung (95 %)</translation>
    </message>
    <message>
        <source>distance from the origin</source>
        <translation>Abstand vom Ursprung</translation>
    </message>
    <message>
        <source>path length from the origin</source>
        <translation>Weg vom Ursprung</translation>
    </message>
    <message>
        <source>This result holds no paths from the origin</source>
        <translation>Dieses Ergebnis enthält keine Wege vom Ursprung</translation>
    </message>
    <message>
        <source>distance from the fitted surface</source>
        <translation>Abstand von der angepassten Fläche</translation>
    </message>
    <message>
        <source>No surface was fitted yet</source>
        <translation>Noch ist keine Fläche angepasst</translation>
    </message>
    <message>
        <source>placed by</source>
        <translation>verortet durch</translation>
    </message>
    <message>
        <source>patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>body part</source>
        <translation>Körperteil</translation>
    </message>
    <message>
        <source>The skin does not say which body part its cells are on</source>
        <translation>Die Haut sagt nicht, auf welchem Körperteil ihre Zellen sind</translation>
    </message>
    <message>
        <source>reading x</source>
        <translation>Messwert x</translation>
    </message>
    <message>
        <source>newest reading along x</source>
        <translation>neuester Messwert entlang x</translation>
    </message>
    <message>
        <source>There are no readings: connect a skin</source>
        <translation>Es gibt keine Messwerte: eine Haut verbinden</translation>
    </message>
    <message>
        <source>reading y</source>
        <translation>Messwert y</translation>
    </message>
    <message>
        <source>newest reading along y</source>
        <translation>neuester Messwert entlang y</translation>
    </message>
    <message>
        <source>reading z</source>
        <translation>Messwert z</translation>
    </message>
    <message>
        <source>newest reading along z</source>
        <translation>neuester Messwert entlang z</translation>
    </message>
    <message>
        <source>reading, norm</source>
        <translation>Messwert, Betrag</translation>
    </message>
    <message>
        <source>norm of the newest reading</source>
        <translation>Betrag des neuesten Messwerts</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>The skin sends no temperatures</source>
        <translation>Die Haut sendet keine Temperaturen</translation>
    </message>
    <message>
        <source>patch %1</source>
        <translation>Hautstück %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>largest bend of the cell&apos;s links</source>
        <translation>größte Biegung der Verbindungen der Zelle</translation>
    </message>
    <message>
        <source>largest twist of the cell&apos;s links</source>
        <translation>größte Verwindung der Verbindungen der Zelle</translation>
    </message>
    <message>
        <source>largest yaw of the cell&apos;s links</source>
        <translation>größtes Gieren der Verbindungen der Zelle</translation>
    </message>
    <message>
        <source>uncertainty of the shape</source>
        <translation>Unsicherheit der Form</translation>
    </message>
    <message>
        <source>uncertainty of the shape (95 %)</source>
        <translation>Unsicherheit der Form (95 %)</translation>
    </message>
    <message>
        <source>This result does not state how well its shape is known</source>
        <translation>Dieses Ergebnis nennt nicht, wie gut seine Form bekannt ist</translation>
    </message>
    <message>
        <source>orientation in the shape</source>
        <translation>Orientierung in der Form</translation>
    </message>
    <message>
        <source>uncertainty of the orientation in the shape (95 %)</source>
        <translation>Unsicherheit der Orientierung in der Form (95 %)</translation>
    </message>
</context>
<context>
    <name>hexoderm::ComparePresenter</name>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>the result before the last change</source>
        <translation>das Ergebnis vor der letzten Änderung</translation>
    </message>
    <message>
        <source>%1, of the step Verify</source>
        <translation>%1, aus dem Schritt Nachprüfen</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: change something, take another pose, or choose an earlier calibration in the step Verify.</source>
        <translation>Noch gibt es nichts zu vergleichen: etwas ändern, eine weitere Pose aufnehmen oder im Schritt Nachprüfen eine frühere Kalibrierung wählen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::CompareView</name>
    <message>
        <source>BEFORE</source>
        <translation>VORHER</translation>
    </message>
    <message>
        <source>NOW</source>
        <translation>JETZT</translation>
    </message>
    <message>
        <source>The patch before</source>
        <translation>Das Hautstück vorher</translation>
    </message>
    <message>
        <source>The patch now</source>
        <translation>Das Hautstück jetzt</translation>
    </message>
    <message>
        <source>What the result of now is compared with</source>
        <translation>Womit das jetzige Ergebnis verglichen wird</translation>
    </message>
    <message>
        <source>Before:</source>
        <translation>Vorher:</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Both results, seen from the same side</source>
        <translation>Beide Ergebnisse, von derselben Seite gesehen</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>The result of now, with an arrow from where each cell was</source>
        <translation>Das jetzige Ergebnis, mit einem Pfeil von dort, wo jede Zelle war</translation>
    </message>
    <message>
        <source>Enlargement of the arrows</source>
        <translation>Vergrößerung der Pfeile</translation>
    </message>
    <message>
        <source>Arrows enlarged</source>
        <translation>Pfeile vergrößert</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>The two have no cells in common.</source>
        <translation>Die beiden haben keine Zelle gemeinsam.</translation>
    </message>
    <message>
        <source>%1 cells in common. Between before and now they lie %2 apart and are turned by %3 (rms, after the best fit of both); cell %4 has moved most, by %5.</source>
        <translation>%1 gemeinsame Zellen. Zwischen vorher und jetzt liegen sie %2 auseinander und sind um %3 gedreht (quadratisches Mittel, nach bester Anpassung aneinander); am meisten hat sich Zelle %4 bewegt, um %5.</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
</context>
<context>
    <name>hexoderm::ConnectDialog</name>
    <message>
        <source>Simulated skin</source>
        <translation>Simulierte Haut</translation>
    </message>
    <message>
        <source>Network, TCP</source>
        <translation>Netz, TCP</translation>
    </message>
    <message>
        <source>Name or number of the device, a colon and its port.</source>
        <translation>Name oder Nummer des Geräts, ein Doppelpunkt und sein Port.</translation>
    </message>
    <message>
        <source>Network, UDP</source>
        <translation>Netz, UDP</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Serielle Schnittstelle</translation>
    </message>
    <message>
        <source>The ports that are there now are in the list.</source>
        <translation>Die gerade vorhandenen Schnittstellen stehen in der Liste.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>A file that hexoderm-cli capture --record has made; ?speed=4 behind it plays it faster.</source>
        <translation>Eine Datei von hexoderm-cli capture --record; ?speed=4 dahinter spielt sie schneller ab.</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Connect to a skin</source>
        <translation>Mit einer Haut verbinden</translation>
    </message>
    <message>
        <source>Where is the skin?</source>
        <translation>Wo ist die Haut?</translation>
    </message>
    <message>
        <source>Kind of connection</source>
        <translation>Art der Verbindung</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Add the poses to the session that is open, %1</source>
        <translation>Die Posen der offenen Sitzung %1 hinzufügen</translation>
    </message>
    <message>
        <source>File that the poses are kept in</source>
        <translation>Datei, in der die Posen liegen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>A&amp;dresse</translation>
    </message>
    <message>
        <source>K&amp;eep in</source>
        <translation>A&amp;blegen in</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>zum Beispiel %1</translation>
    </message>
    <message>
        <source>No serial port is there now; plug the device in, or type the name of its port.</source>
        <translation>Es gibt gerade keine serielle Schnittstelle; das Gerät anstecken oder den Namen seiner Schnittstelle eintippen.</translation>
    </message>
    <message>
        <source>Recording to play</source>
        <translation>Aufzeichnung zum Abspielen</translation>
    </message>
    <message>
        <source>Keep the poses in</source>
        <translation>Sitzungsdatei</translation>
    </message>
    <message>
        <source>Sessions (*.hexo)</source>
        <translation>Sitzungen (*.hexo)</translation>
    </message>
    <message>
        <source>Say which file the poses should be kept in.</source>
        <translation>Angeben, in welcher Datei die Posen liegen sollen.</translation>
    </message>
    <message>
        <source>The file&apos;s name should end in %1.</source>
        <translation>Der Dateiname soll auf %1 enden.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>There is a file of this name, and a capture never replaces one.</source>
        <translation>Es gibt eine Datei dieses Namens, und eine Aufnahme ersetzt nie eine.</translation>
    </message>
    <message>
        <source>Nothing can be written in the folder %1.</source>
        <translation>Im Ordner %1 lässt sich nichts schreiben.</translation>
    </message>
    <message>
        <source>Type an address, for example %1.</source>
        <translation>Eine Adresse eintippen, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>Die Datei %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>Every pose is written to this file before it is called captured.</source>
        <translation>Jede Pose wird in diese Datei geschrieben, bevor sie als aufgenommen gilt.</translation>
    </message>
    <message>
        <source>x17, ring8 or sheet:10x10, also with options: x17?seed=1&amp;speed=2; or robot, an arm with two patches. Its readings are made up.</source>
        <translation>x17, ring8 oder sheet:10x10, auch mit Optionen: x17?seed=1&amp;speed=2; oder robot, ein Arm mit zwei Hautstücken. Die Messwerte sind simuliert.</translation>
    </message>
</context>
<context>
    <name>hexoderm::ConnectionPresenter</name>
    <message>
        <source>Since the skin was connected: %1. Poses need no more than their own samples, so a few lost ones do no harm; many speak of a slow network or cable.</source>
        <translation>Seit die Haut verbunden ist: %1. Posen brauchen nur ihre eigenen Messwerte, einzelne verlorene schaden nicht; viele sprechen für ein langsames Netz oder Kabel.</translation>
    </message>
    <message>
        <source>Demo skin</source>
        <translation>Demo-Haut</translation>
    </message>
    <message>
        <source>The device does something wrong: %1</source>
        <translation>Das Gerät macht etwas falsch: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::CoverageView</name>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>nächste</translation>
    </message>
    <message>
        <source>Directions of gravity seen</source>
        <translation>Gesehene Richtungen der Schwerkraft</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>1st</source>
        <translation>1.</translation>
    </message>
    <message>
        <source>2nd</source>
        <translation>2.</translation>
    </message>
    <message>
        <source>3rd</source>
        <translation>3.</translation>
    </message>
    <message>
        <source>%1 · mark: enough</source>
        <translation>%1 · Marke: genügt</translation>
    </message>
    <message>
        <source>Front: up is where the origin cell faces. Back: the other half, seen from behind.
The bars say how much the directions seen differ, along three axes (their singular values). Two that reach their mark, %1, fix how the cells are turned; the third tells the sensors&apos; errors apart from that.</source>
        <translation>Vorn: Oben ist, wohin die Ursprungszelle zeigt. Hinten: die andere Hälfte, von hinten gesehen.
Die Balken sagen, wie sehr sich die gesehenen Richtungen in drei Achsen unterscheiden (ihre Singulärwerte). Zwei, die ihre Marke %1 erreichen, legen fest, wie die Zellen gedreht sind; der dritte trennt davon die Fehler der Sensoren.</translation>
    </message>
</context>
<context>
    <name>hexoderm::CsvActions</name>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
</context>
<context>
    <name>hexoderm::CutBar</name>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Depth of the cut</source>
        <translation>Tiefe des Schnitts</translation>
    </message>
    <message>
        <source>How much of the skin is taken away from in front</source>
        <translation>Wie viel von der Haut von vorn weggenommen wird</translation>
    </message>
    <message>
        <source>Face me</source>
        <translation>Zu mir drehen</translation>
    </message>
    <message>
        <source>Turns the cut so that it faces you as you look now</source>
        <translation>Dreht den Schnitt so, dass er dem Betrachter zugewandt ist</translation>
    </message>
</context>
<context>
    <name>hexoderm::EditCommand</name>
    <message>
        <source>take pose %1</source>
        <translation>Pose %1 aufnehmen</translation>
    </message>
    <message>
        <source>delete pose %1</source>
        <translation>Pose %1 löschen</translation>
    </message>
    <message>
        <source>disable pose %1</source>
        <translation>Pose %1 nicht benutzen</translation>
    </message>
    <message>
        <source>enable pose %1</source>
        <translation>Pose %1 wieder benutzen</translation>
    </message>
    <message>
        <source>set link %1 aside</source>
        <translation>Verbindung %1 ausschließen</translation>
    </message>
    <message>
        <source>take link %1 back</source>
        <translation>Verbindung %1 zurücknehmen</translation>
    </message>
    <message>
        <source>set the joint angles of pose %1</source>
        <translation>Gelenkwinkel von Pose %1 setzen</translation>
    </message>
    <message>
        <source>choose the robot</source>
        <translation>Roboter wählen</translation>
    </message>
    <message>
        <source>remove the robot</source>
        <translation>Roboter entfernen</translation>
    </message>
    <message>
        <source>place the patch of cell %1</source>
        <translation>Hautstück von Zelle %1 einordnen</translation>
    </message>
    <message>
        <source>say where the skin lies</source>
        <translation>Lage der Haut angeben</translation>
    </message>
</context>
<context>
    <name>hexoderm::EventLog</name>
    <message>
        <source>The folder %1 can&apos;t be made.</source>
        <translation>Der Ordner %1 lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>%1 lines are missing here: they could not be written, or came too fast</source>
        <translation>Hier fehlen %1 Zeilen: Sie ließen sich nicht schreiben oder kamen zu schnell</translation>
    </message>
</context>
<context>
    <name>hexoderm::EventRecorder</name>
    <message>
        <source>Solved: %1, %2, %3, %4 ms. %5</source>
        <translation>Gelöst: %1, %2, %3, %4 ms. %5</translation>
    </message>
    <message>
        <source>Hexoderm %1 starts</source>
        <translation>Hexoderm %1 startet</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>Verlangt: %1</translation>
    </message>
    <message>
        <source>Skin at %1: %2. %3</source>
        <translation>Haut unter %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>hexoderm::ExportDialog</name>
    <message>
        <source>File to write</source>
        <translation>Zieldatei</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>Kalibrierung exportieren</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Hexoderm&apos;s own file: everything that is known, to be opened again, compared and exported from later.</source>
        <translation>Hexoderms eigene Datei: alles, was bekannt ist, um es später zu öffnen, zu vergleichen und zu exportieren.</translation>
    </message>
    <message>
        <source>Say where the file should go.</source>
        <translation>Angeben, wohin die Datei soll.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 is a folder; give the file a name.</source>
        <translation>%1 ist ein Ordner; der Datei einen Namen geben.</translation>
    </message>
    <message>
        <source>The tables in this folder will be replaced.</source>
        <translation>Die Tabellen in diesem Ordner werden ersetzt.</translation>
    </message>
    <message>
        <source>There is a file of this name; it will be replaced.</source>
        <translation>Es gibt eine Datei dieses Namens; sie wird ersetzt.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>How the patches lie to each other is not known, so that a file with one frame holds one</source>
        <translation>Wie die Hautstücke zueinander liegen, ist nicht bekannt; eine Datei mit einem einzigen Koordinatensystem enthält deshalb nur eines</translation>
    </message>
    <message>
        <source>All, each in its own frame</source>
        <translation>Alle, jedes in seinem eigenen Koordinatensystem</translation>
    </message>
    <message>
        <source>Cell %1 alone</source>
        <translation>Zelle %1 allein</translation>
    </message>
    <message>
        <source>Patch of cell %1, %2 cells</source>
        <translation>Hautstück der Zelle %1, %2 Zellen</translation>
    </message>
    <message>
        <source>All that are placed on the robot</source>
        <translation>Alle, die am Roboter eingeordnet sind</translation>
    </message>
    <message>
        <source>One file or several</source>
        <translation>Eine Datei oder mehrere</translation>
    </message>
    <message>
        <source>One &amp;file</source>
        <translation>Eine &amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Package</source>
        <translation>&amp;Paket</translation>
    </message>
    <message>
        <source>What each file will hold</source>
        <translation>Was jede Datei enthalten wird</translation>
    </message>
    <message>
        <source>Folder or archive</source>
        <translation>Ordner oder Archiv</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Zip archive</source>
        <translation>Zip-Archiv</translation>
    </message>
    <message>
        <source>As many as each format can hold</source>
        <translation>So viele, wie jedes Format fasst</translation>
    </message>
    <message>
        <source>Tick the files that the package is to hold.</source>
        <translation>Die Dateien ankreuzen, die das Paket enthalten soll.</translation>
    </message>
    <message>
        <source>Say where the package should go.</source>
        <translation>Angeben, wohin das Paket soll.</translation>
    </message>
    <message>
        <source>%1 is a file; give the folder another name.</source>
        <translation>%1 ist eine Datei; dem Ordner einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>There is a folder of this name; files of the same names in it are replaced.</source>
        <translation>Es gibt einen Ordner dieses Namens; gleichnamige Dateien darin werden ersetzt.</translation>
    </message>
</context>
<context>
    <name>hexoderm::ExportPresenter</name>
    <message>
        <source>Keep</source>
        <translation>Merken</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Documents (*.pdf);;Pages for the browser (*.html)</source>
        <translation>Dokumente (*.pdf);;Seiten für den Browser (*.html)</translation>
    </message>
    <message>
        <source>Not to be trusted</source>
        <translation>Nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>Export all the same</source>
        <translation>Trotzdem exportieren</translation>
    </message>
</context>
<context>
    <name>hexoderm::FigureCard</name>
    <message>
        <source>Close this card (Esc)</source>
        <translation>Diese Karte schließen (Esc)</translation>
    </message>
    <message>
        <source>Close the card with the figures</source>
        <translation>Die Karte mit den Werten schließen</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Go to cell %1</source>
        <translation>Zu Zelle %1 gehen</translation>
    </message>
</context>
<context>
    <name>hexoderm::FilePresenter</name>
    <message>
        <source>Saved to %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert: %1</translation>
    </message>
    <message>
        <source>Not on disk yet; it waits in memory and the work can go on. %1</source>
        <translation>Noch nicht auf der Platte; es wartet im Speicher, und die Arbeit kann weitergehen. %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Open a session or a calibration</source>
        <translation>Sitzung oder Kalibrierung öffnen</translation>
    </message>
    <message>
        <source>Sessions and calibrations (*.hexo *.json *.xml)</source>
        <translation>Sitzungen und Kalibrierungen (*.hexo *.json *.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.session.json);;Sessions that keep every change (*.hexo)</source>
        <translation>Sitzungen (*.session.json);;Sitzungen, die jede Änderung behalten (*.hexo)</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>Kalibrierung speichern</translation>
    </message>
    <message>
        <source>Calibrations (*.calibration.json)</source>
        <translation>Kalibrierungen (*.calibration.json)</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>No program to show folders was found. The folder is %1.</source>
        <translation>Es wurde kein Programm gefunden, das Ordner zeigt. Der Ordner ist %1.</translation>
    </message>
    <message>
        <source>Unsaved poses</source>
        <translation>Nicht gespeicherte Posen</translation>
    </message>
    <message>
        <source>Save the session first? Its latest changes are not on disk yet.</source>
        <translation>Die Sitzung vorher speichern? Ihre letzten Änderungen sind noch nicht auf der Platte.</translation>
    </message>
    <message>
        <source>Exported to %1. %2</source>
        <translation>Exportiert nach %1. %2</translation>
    </message>
</context>
<context>
    <name>hexoderm::FindCellField</name>
    <message>
        <source>Find cell…</source>
        <translation>Zelle suchen…</translation>
    </message>
    <message>
        <source>ID of the cell to find</source>
        <translation>ID der gesuchten Zelle</translation>
    </message>
    <message>
        <source>no such cell</source>
        <translation>keine solche Zelle</translation>
    </message>
</context>
<context>
    <name>hexoderm::FindingCard</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
    <message>
        <source>Why: %1</source>
        <translation>Warum: %1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Was tun: %1</translation>
    </message>
    <message>
        <source>Less ▴</source>
        <translation>Weniger ▴</translation>
    </message>
    <message>
        <source>Why, and what to do ▾</source>
        <translation>Warum, und was tun ▾</translation>
    </message>
    <message>
        <source>Fold the reasons away</source>
        <translation>Die Gründe zuklappen</translation>
    </message>
    <message>
        <source>Why, and what to do</source>
        <translation>Warum, und was tun</translation>
    </message>
</context>
<context>
    <name>hexoderm::FindingCards</name>
    <message>
        <source>%1 more under Findings</source>
        <translation>%1 weitere unter Befunde</translation>
    </message>
</context>
<context>
    <name>hexoderm::FindingPresenter</name>
    <message>
        <source>Take link back</source>
        <translation>Verbindung wieder zulassen</translation>
    </message>
    <message>
        <source>Set link aside</source>
        <translation>Verbindung ausschließen</translation>
    </message>
    <message>
        <source>Enable pose %1</source>
        <translation>Pose %1 wieder benutzen</translation>
    </message>
    <message>
        <source>Disable pose %1</source>
        <translation>Pose %1 nicht benutzen</translation>
    </message>
    <message>
        <source>Take pose %1 again</source>
        <translation>Pose %1 neu aufnehmen</translation>
    </message>
    <message>
        <source>Take another pose</source>
        <translation>Eine weitere Pose aufnehmen</translation>
    </message>
    <message>
        <source>Light off</source>
        <translation>Licht aus</translation>
    </message>
    <message>
        <source>Light cell %1</source>
        <translation>Zelle %1 beleuchten</translation>
    </message>
    <message>
        <source>Take the first pose</source>
        <translation>Erste Pose aufnehmen</translation>
    </message>
</context>
<context>
    <name>hexoderm::FindingTable</name>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
</context>
<context>
    <name>hexoderm::FoldingRow</name>
    <message>
        <source>More ▾</source>
        <translation>Mehr ▾</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>What finds no room beside this</source>
        <translation>Was daneben keinen Platz findet</translation>
    </message>
</context>
<context>
    <name>hexoderm::GraphColoringButton</name>
    <message>
        <source>What the colours of links and cells show</source>
        <translation>Was die Farben der Verbindungen und Zellen zeigen</translation>
    </message>
    <message>
        <source>Mark the &amp;shortest paths</source>
        <translation>&amp;Kürzeste Wege markieren</translation>
    </message>
    <message>
        <source>A band under the links on the shortest paths to the origin</source>
        <translation>Ein Band unter den Verbindungen auf den kürzesten Wegen zum Ursprung</translation>
    </message>
    <message>
        <source>Colour: %1 ▾</source>
        <translation>Farbe: %1 ▾</translation>
    </message>
    <message>
        <source>Colour of the graph: %1</source>
        <translation>Farbe des Graphen: %1</translation>
    </message>
    <message>
        <source>This skin does not say which body parts its cells are on</source>
        <translation>Diese Haut sagt nicht, auf welchen Körperteilen ihre Zellen sind</translation>
    </message>
</context>
<context>
    <name>hexoderm::GraphLegend</name>
    <message>
        <source>and so on</source>
        <translation>und so weiter</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>shortest paths</source>
        <translation>kürzeste Wege</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>range fixed</source>
        <translation>Bereich fest</translation>
    </message>
</context>
<context>
    <name>hexoderm::GraphPaint</name>
    <message>
        <source>own readings</source>
        <translation>eigene Messwerte</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verbindungen</translation>
    </message>
</context>
<context>
    <name>hexoderm::GraphPointing</name>
    <message>
        <source>No skin is open.</source>
        <translation>Keine Haut ist offen.</translation>
    </message>
    <message>
        <source>Picked: cell %1</source>
        <translation>Gewählt: Zelle %1</translation>
    </message>
    <message>
        <source>Picked: %1, %2</source>
        <translation>Gewählt: %1, %2</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht benutzt</translation>
    </message>
</context>
<context>
    <name>hexoderm::GraphView</name>
    <message>
        <source>Patch %1</source>
        <translation>Hautstück %1</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>This skin has no cells.</source>
        <translation>Diese Haut hat keine Zellen.</translation>
    </message>
    <message>
        <source>The skin graph appears here as soon as a skin is open.</source>
        <translation>Der Hautgraph erscheint hier, sobald eine Haut offen ist.</translation>
    </message>
    <message>
        <source>Skin graph</source>
        <translation>Hautgraph</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Find &amp;cell…</source>
        <translation>&amp;Zelle suchen…</translation>
    </message>
    <message>
        <source>Copy pict&amp;ure</source>
        <translation>B&amp;ild kopieren</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>Bild &amp;speichern…</translation>
    </message>
</context>
<context>
    <name>hexoderm::Guide</name>
    <message>
        <source>no findings</source>
        <translation>keine Befunde</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>1 Befund</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>%1 Befunde</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Check that the device is switched on, and that its address is right.</source>
        <translation>Prüfen, ob das Gerät eingeschaltet ist und seine Adresse stimmt.</translation>
    </message>
    <message>
        <source>The steps go on when the skin has said which cells it has.</source>
        <translation>Weiter geht es, wenn die Haut gesagt hat, welche Zellen sie hat.</translation>
    </message>
    <message>
        <source>Disconnect, and connect to another skin or recording.</source>
        <translation>Trennen und mit einer anderen Haut oder Aufzeichnung verbinden.</translation>
    </message>
    <message>
        <source>Nothing more will come from this one.</source>
        <translation>Von hier kommt nichts mehr.</translation>
    </message>
    <message>
        <source>Start the demo skin, connect to a skin, or open a session or a calibration.</source>
        <translation>Die Demo-Haut starten, eine Haut verbinden oder eine Sitzung oder Kalibrierung öffnen.</translation>
    </message>
    <message>
        <source>A file can also be dropped onto this window. The demo is a simulation of 17 cells on a cylinder; everything can be tried with it.</source>
        <translation>Eine Datei lässt sich auch auf dieses Fenster ziehen. Die Demo ist eine Simulation von 17 Zellen auf einem Zylinder; mit ihr lässt sich alles ausprobieren.</translation>
    </message>
    <message>
        <source>Check the skin</source>
        <translation>Haut prüfen</translation>
    </message>
    <message>
        <source>Waits for a skin.</source>
        <translation>Wartet auf eine Haut.</translation>
    </message>
    <message>
        <source>Every cell and every link should be there. What was reported but can&apos;t be a skin link is listed under Findings and kept out.</source>
        <translation>Jede Zelle und jede Verbindung soll da sein. Was gemeldet wurde, aber keine Hautverbindung sein kann, steht unter Befunde und bleibt außen vor.</translation>
    </message>
    <message>
        <source>Capture poses</source>
        <translation>Posen aufnehmen</translation>
    </message>
    <message>
        <source>A calibration is open. It holds the result; the poses are in its session.</source>
        <translation>Eine Kalibrierung ist offen. Sie enthält das Ergebnis; die Posen stehen in ihrer Sitzung.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <source>Waits for a reconstruction.</source>
        <translation>Wartet auf ein Ergebnis.</translation>
    </message>
    <message>
        <source>A pose that does not fit can be disabled or deleted in the table of poses, and taken back with undo. A click on a finding shows the cell or link it is about.</source>
        <translation>Eine Pose, die nicht passt, lässt sich in der Tabelle der Posen auf „nicht benutzen“ setzen oder löschen und mit Rückgängig zurückholen. Ein Klick auf einen Befund zeigt die Zelle oder Verbindung, um die es geht.</translation>
    </message>
    <message>
        <source>A click on a finding shows the cell or link it is about.</source>
        <translation>Ein Klick auf einen Befund zeigt die Zelle oder Verbindung, um die es geht.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the placements in the form you need.</source>
        <translation>Die Lagen im gewünschten Format speichern.</translation>
    </message>
    <message>
        <source>Every file is read back and compared before it is called written.</source>
        <translation>Jede Datei wird zurückgelesen und verglichen, bevor sie als geschrieben gilt.</translation>
    </message>
    <message>
        <source>It can be exported as it is, but the result is not good enough yet: see the line on top.</source>
        <translation>Es lässt sich exportieren, wie es ist, aber das Ergebnis ist noch nicht gut genug: siehe die Zeile oben.</translation>
    </message>
    <message>
        <source>Waiting for the skin at %1.</source>
        <translation>Wartet auf die Haut unter %1.</translation>
    </message>
    <message>
        <source>No skin came from %1.</source>
        <translation>Von %1 kam keine Haut.</translation>
    </message>
    <message>
        <source>Nothing more will come from this skin. The poses stay; connect to a skin to take more.</source>
        <translation>Von dieser Haut kommt nichts mehr. Die Posen bleiben; für weitere mit einer Haut verbinden.</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>No skin yet: start the demo, connect to a skin, or open a session or a calibration.</source>
        <translation>Noch keine Haut: die Demo starten, eine Haut verbinden oder eine Sitzung oder Kalibrierung öffnen.</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Nachprüfen</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>optional</translation>
    </message>
    <message>
        <source>See whether the result holds.</source>
        <translation>Prüfen, ob das Ergebnis standhält.</translation>
    </message>
    <message>
        <source>Gravity seen from several directions tells how every cell is turned against its neighbours. No skin is connected to take more.</source>
        <translation>Schwerkraft aus mehreren Richtungen verrät, wie jede Zelle gegen ihre Nachbarn gedreht ist. Für weitere Posen ist keine Haut verbunden.</translation>
    </message>
    <message>
        <source>There is no skin yet.</source>
        <translation>Noch gibt es keine Haut.</translation>
    </message>
    <message>
        <source>Nothing is connected and nothing is open yet.</source>
        <translation>Noch ist nichts verbunden und nichts offen.</translation>
    </message>
    <message>
        <source>The skin has said which cells it has, and sends.</source>
        <translation>Die Haut hat gesagt, welche Zellen sie hat, und sendet.</translation>
    </message>
    <message>
        <source>A session is open.</source>
        <translation>Eine Sitzung ist offen.</translation>
    </message>
    <message>
        <source>A calibration is open.</source>
        <translation>Eine Kalibrierung ist offen.</translation>
    </message>
    <message>
        <source>The cells and links are those of the file.</source>
        <translation>Zellen und Verbindungen sind die der Datei.</translation>
    </message>
    <message>
        <source>The skin sends.</source>
        <translation>Die Haut sendet.</translation>
    </message>
    <message>
        <source>There is a result of everything that was captured.</source>
        <translation>Es gibt ein Ergebnis aus allem, was aufgenommen wurde.</translation>
    </message>
    <message>
        <source>No pose has been captured yet.</source>
        <translation>Noch ist keine Pose aufgenommen.</translation>
    </message>
    <message>
        <source>A simulated skin in a simulated hand. Its readings err as those of a real skin do.</source>
        <translation>Eine simulierte Haut in einer simulierten Hand. Ihre Messwerte haben Fehler wie die einer echten Haut.</translation>
    </message>
    <message>
        <source>There is a result of %1.</source>
        <translation>Es gibt ein Ergebnis aus %1.</translation>
    </message>
    <message>
        <source>There is a result to check.</source>
        <translation>Es gibt ein Ergebnis, das sich prüfen lässt.</translation>
    </message>
    <message>
        <source>Each check uses something that did not go into the result.</source>
        <translation>Jede Prüfung nutzt etwas, das in das Ergebnis nicht eingegangen ist.</translation>
    </message>
    <message>
        <source>The simulated robot</source>
        <translation>Der simulierte Roboter</translation>
    </message>
    <message>
        <source>The robot</source>
        <translation>Der Roboter</translation>
    </message>
    <message>
        <source>%1 is taking pose %2.</source>
        <translation>%1 nimmt Pose %2 auf.</translation>
    </message>
    <message>
        <source>The skin has said which cells it has.</source>
        <translation>Die Haut hat gesagt, welche Zellen sie hat.</translation>
    </message>
    <message>
        <source>The first readings are on their way.</source>
        <translation>Die ersten Messwerte sind unterwegs.</translation>
    </message>
    <message>
        <source>Without a pose, a file only holds what follows from the ports.</source>
        <translation>Ohne Pose enthält eine Datei nur, was aus den Ports folgt.</translation>
    </message>
    <message>
        <source>The placements could not be worked out: see the log.</source>
        <translation>Die Lagen der Zellen konnten nicht berechnet werden: siehe das Protokoll.</translation>
    </message>
    <message>
        <source>The placement of the cell is being worked out…</source>
        <translation>Die Lage der Zelle wird berechnet…</translation>
    </message>
    <message>
        <source>The placements of %1 cells are being worked out…</source>
        <translation>Die Lagen der %1 Zellen werden berechnet…</translation>
    </message>
    <message>
        <source>%1 of %2 patches placed</source>
        <translation>%1 von %2 Hautstücken eingeordnet</translation>
    </message>
    <message>
        <source>Place on the robot</source>
        <translation>Am Roboter einordnen</translation>
    </message>
    <message>
        <source>A calibration is open: it holds the result, not the poses.</source>
        <translation>Eine Kalibrierung ist geöffnet: Sie enthält das Ergebnis, nicht die Posen.</translation>
    </message>
    <message>
        <source>There is a result to place.</source>
        <translation>Es gibt ein Ergebnis, das sich einordnen lässt.</translation>
    </message>
    <message>
        <source>Say where on the robot each patch is.</source>
        <translation>Angeben, wo am Roboter jedes Hautstück ist.</translation>
    </message>
    <message>
        <source>With the robot&apos;s description and its joint angles, gravity tells which link a patch is on and how it is turned there; the link&apos;s surface, or known points, tell where. Files for robots need it.</source>
        <translation>Mit der Beschreibung des Roboters und seinen Gelenkwinkeln verrät die Schwerkraft, auf welchem Glied ein Hautstück liegt und wie es dort gedreht ist; die Oberfläche des Glieds oder bekannte Punkte sagen, wo. Dateien für Roboter brauchen das.</translation>
    </message>
    <message>
        <source>Look at what was found, the worst first.</source>
        <translation>Die Befunde ansehen, den schlimmsten zuerst.</translation>
    </message>
    <message>
        <source>Nothing was found that does not fit.</source>
        <translation>Es wurde nichts gefunden, was nicht passt.</translation>
    </message>
    <message>
        <source>The skin does not send any more. Check cable, power and address: once it sends again, this goes on by itself.</source>
        <translation>Die Haut sendet nicht mehr. Kabel, Stromversorgung und Adresse prüfen: Sobald sie wieder sendet, geht es von selbst weiter.</translation>
    </message>
    <message>
        <source>Working out the placements was stopped.</source>
        <translation>Die Berechnung der Lagen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Working out the last change was stopped: the result shown is from before it.</source>
        <translation>Die Berechnung der letzten Änderung wurde abgebrochen: Das gezeigte Ergebnis ist das davor.</translation>
    </message>
    <message>
        <source>Compare the skin graph (G makes it large) with the skin in front of you.</source>
        <translation>Den Hautgraphen (G macht ihn groß) mit der wirklichen Haut vergleichen.</translation>
    </message>
    <message>
        <source>%1 cells are placed for now, and the result is being worked out…</source>
        <translation>%1 Zellen sind vorläufig platziert, das Ergebnis wird noch berechnet…</translation>
    </message>
    <message>
        <source>Nothing was found that does not fit. There are notes only.</source>
        <translation>Es wurde nichts gefunden, was nicht passt. Es gibt nur Hinweise.</translation>
    </message>
    <message>
        <source>The result is not to be trusted, as the line on top says: before it is exported, a question is asked.</source>
        <translation>Dem Ergebnis ist nicht zu trauen, wie die Zeile oben sagt: Vor dem Export wird nachgefragt.</translation>
    </message>
</context>
<context>
    <name>hexoderm::GuideWindow</name>
    <message>
        <source>en</source>
        <comment>language of the user guide</comment>
        <extracomment>The folder of the user guide in this language: a two-letter code.</extracomment>
        <translation>de</translation>
    </message>
    <message>
        <source>User guide · Hexoderm</source>
        <translation>Anleitung · Hexoderm</translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation>Seiten der Anleitung</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>Seite der Anleitung</translation>
    </message>
    <message>
        <source>Search in this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>Back to the page before</source>
        <translation>Zurück zur Seite davor</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>Wieder vor</translation>
    </message>
    <message>
        <source>Find the one before</source>
        <translation>Vorige Stelle</translation>
    </message>
    <message>
        <source>Find the next one</source>
        <translation>Nächste Stelle</translation>
    </message>
</context>
<context>
    <name>hexoderm::HoldRing</name>
    <message>
        <source>How long the part has been held</source>
        <translation>Wie lange das Teil schon gehalten wird</translation>
    </message>
</context>
<context>
    <name>hexoderm::JointTable</name>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>The block has %1 rows and %2 columns, and from here there is room for %3 and %4.</source>
        <translation>Der Block hat %1 Zeilen und %2 Spalten, und von hier an ist Platz für %3 und %4.</translation>
    </message>
    <message>
        <source>Pose %1, joint %2</source>
        <translation>Pose %1, Gelenk %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number: joint %2 in pose %3 takes millimetres.</source>
        <translation>„%1“ ist keine Zahl: Gelenk %2 in Pose %3 nimmt Millimeter.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number: joint %2 in pose %3 takes degrees.</source>
        <translation>„%1“ ist keine Zahl: Gelenk %2 in Pose %3 nimmt Grad.</translation>
    </message>
    <message>
        <source>%1 is no position of joint %2.</source>
        <translation>%1 ist keine Stellung von Gelenk %2.</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>Joint %1, %2</source>
        <translation>Gelenk %1, %2</translation>
    </message>
    <message>
        <source>Joint %1, without limits</source>
        <translation>Gelenk %1, ohne Grenzen</translation>
    </message>
</context>
<context>
    <name>hexoderm::JointTableView</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
</context>
<context>
    <name>hexoderm::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Cancel or close what is open; never quits</source>
        <translation>Bricht ab oder schließt, was offen ist; beendet nie</translation>
    </message>
    <message>
        <source>Go to the next control, with Shift to the one before</source>
        <translation>Zum nächsten Bedienelement, mit Umschalt zum vorigen</translation>
    </message>
    <message>
        <source>Press the button that has the focus</source>
        <translation>Den Knopf mit dem Fokus drücken</translation>
    </message>
    <message>
        <source>Open the picked row or recent file</source>
        <translation>Die gewählte Zeile oder letzte Datei öffnen</translation>
    </message>
    <message>
        <source>Search for a key or for what it does</source>
        <translation>Taste oder Wirkung suchen</translation>
    </message>
    <message>
        <source>No key is like that.</source>
        <translation>Keine Taste passt dazu.</translation>
    </message>
</context>
<context>
    <name>hexoderm::LinkTable</name>
    <message>
        <source>muted</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>used, in tree</source>
        <translation>benutzt, im Baum</translation>
    </message>
    <message>
        <source>used</source>
        <translation>benutzt</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Cell and port of both ends</source>
        <translation>Zelle und Port beider Enden</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>How well the poses determine the link&apos;s rotation</source>
        <translation>Wie gut die Posen die Drehung der Verbindung bestimmen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>How badly the readings of the two cells fit together, the estimated errors of their sensors taken away: rms over the poses</source>
        <translation>Wie schlecht die Messwerte der beiden Zellen zusammenpassen, ohne die geschätzten Fehler ihrer Sensoren: Effektivwert über die Posen</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Expected standard deviation of the link&apos;s rotation about its worst axis</source>
        <translation>Erwartete Standardabweichung der Drehung der Verbindung um ihre schlechteste Achse</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>Angle by which the surface folds at the link</source>
        <translation>Winkel, um den sich die Fläche an der Verbindung faltet</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verwindung</translation>
    </message>
    <message>
        <source>Angle by which the cells are turned about the line that joins them</source>
        <translation>Winkel, um den die Zellen um ihre Verbindungslinie gedreht sind</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Angle by which the cells are turned within the surface</source>
        <translation>Winkel, um den die Zellen in der Fläche gedreht sind</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Whether the link is used, and whether it lies on the shortest-path tree</source>
        <translation>Ob die Verbindung benutzt wird und ob sie auf dem Baum der kürzesten Wege liegt</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>ausgeschlossen</translation>
    </message>
</context>
<context>
    <name>hexoderm::LiveMode</name>
    <message>
        <source>What is shown stands still: the skin as it is now can&apos;t be solved. %1</source>
        <translation>Das Gezeigte steht still: Die Haut, wie sie jetzt ist, lässt sich nicht lösen. %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::LiveSession</name>
    <message>
        <source>%1 has other cells than the session %2, so nothing was added. Connect it with a session of its own.</source>
        <translation>%1 hat andere Zellen als die Sitzung %2, darum wurde nichts hinzugefügt. Mit einer eigenen Sitzung verbinden.</translation>
    </message>
    <message>
        <source>The session that is open was changed while the skin was being connected, so it stays. Save it, and connect again.</source>
        <translation>Die offene Sitzung wurde geändert, während die Haut verbunden wurde, darum bleibt sie. Speichern und noch einmal verbinden.</translation>
    </message>
    <message>
        <source>Demo skin (simulated)</source>
        <translation>Demo-Haut (simuliert)</translation>
    </message>
    <message>
        <source>recapture pose %1</source>
        <translation>Pose %1 neu aufnehmen</translation>
    </message>
    <message>
        <source>The links are others than those of the session; the poses stay.</source>
        <translation>Die Verbindungen sind andere als die der Sitzung; die Posen bleiben.</translation>
    </message>
    <message>
        <source>The device says that its cells or links have changed; the poses stay.</source>
        <translation>Das Gerät meldet geänderte Zellen oder Verbindungen; die Posen bleiben.</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>Pose %1 captured, in memory only: %2.</source>
        <translation>Pose %1 aufgenommen, nur im Speicher: %2.</translation>
    </message>
    <message>
        <source>Pose %1 captured: %2.</source>
        <translation>Pose %1 aufgenommen: %2.</translation>
    </message>
    <message>
        <source>Nothing came from %1.</source>
        <translation>Nichts kam von %1.</translation>
    </message>
    <message>
        <source>It repeats pose %1, which is only %2° away.</source>
        <translation>Sie wiederholt Pose %1, die nur %2° entfernt ist.</translation>
    </message>
    <message>
        <source>The device says that it has another cell model; the poses stay.</source>
        <translation>Das Gerät meldet ein anderes Zellmodell; die Posen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The device refused to turn %1 times, so it is not asked any more. The last time: %2</source>
        <translation>Das Gerät hat %1-mal abgelehnt, sich zu drehen, und wird nicht mehr gefragt. Zuletzt: %2</translation>
    </message>
    <message>
        <source>The device does not turn there: %1. The next best pose is advised instead.</source>
        <translation>Das Gerät dreht sich nicht dorthin: %1. Stattdessen wird eine andere Pose vorgeschlagen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::LiveStrip</name>
    <message>
        <source>Connected skin</source>
        <translation>Verbundene Haut</translation>
    </message>
    <message>
        <source>Sample frames that came, samples that the device numbered and that never came, and frames that came late</source>
        <translation>Datensätze, die kamen, Messwerte, die das Gerät nummerierte und die nie kamen, und Datensätze, die zu spät kamen</translation>
    </message>
</context>
<context>
    <name>hexoderm::LiveWords</name>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Verbindet</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Streaming</source>
        <translation>Empfängt</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Incompatible</source>
        <translation>Nicht kompatibel</translation>
    </message>
    <message>
        <source>%1 frames · %2 lost · %3 late</source>
        <translation>%1 Datensätze · %2 verloren · %3 verspätet</translation>
    </message>
    <message>
        <source> · %1 broken</source>
        <translation> · %1 kaputt</translation>
    </message>
    <message>
        <source> · %1 unknown</source>
        <translation> · %1 unbekannt</translation>
    </message>
    <message>
        <source> · %1 reconnects</source>
        <translation> · %1-mal neu verbunden</translation>
    </message>
    <message>
        <source> · %1 dropped by the device</source>
        <translation> · %1 vom Gerät verworfen</translation>
    </message>
    <message>
        <source>1 sample lost</source>
        <translation>1 Messwert verloren</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 Messwerte verloren</translation>
    </message>
    <message>
        <source>1 frame late</source>
        <translation>1 Rahmen verspätet</translation>
    </message>
    <message>
        <source>%1 frames late</source>
        <translation>%1 Rahmen verspätet</translation>
    </message>
    <message>
        <source>1 sample dropped by the device</source>
        <translation>1 Messwert vom Gerät verworfen</translation>
    </message>
    <message>
        <source>%1 samples dropped by the device</source>
        <translation>%1 Messwerte vom Gerät verworfen</translation>
    </message>
</context>
<context>
    <name>hexoderm::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
</context>
<context>
    <name>hexoderm::LogView</name>
    <message>
        <source>Which lines of the log are shown</source>
        <translation>Welche Zeilen des Protokolls gezeigt werden</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Warnungen und Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Protokoll durchsuchen</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Für Fehlerbericht kopieren</translation>
    </message>
    <message>
        <source>Copies versions, graphics, what is open and the last 200 lines; your home folder is left out</source>
        <translation>Kopiert Versionen, Grafik, was offen ist und die letzten 200 Zeilen; der eigene Ordner bleibt weg</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>This log is not kept in a file</source>
        <translation>Dieses Protokoll liegt in keiner Datei</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 Zeile</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
</context>
<context>
    <name>hexoderm::MarkPresenter</name>
    <message>
        <source>estimating every link</source>
        <translation>jede Verbindung wird geschätzt</translation>
    </message>
    <message>
        <source>placing all cells together</source>
        <translation>alle Zellen werden gemeinsam platziert</translation>
    </message>
    <message>
        <source>placing the cells of patch %1 of %2</source>
        <translation>die Zellen von Hautstück %1 von %2 werden platziert</translation>
    </message>
    <message>
        <source>looking for what does not fit</source>
        <translation>es wird gesucht, was nicht passt</translation>
    </message>
    <message>
        <source>working out how certain it is</source>
        <translation>es wird berechnet, wie sicher es ist</translation>
    </message>
    <message>
        <source>Working out the result of %1: %2 · %3 s</source>
        <translation>Das Ergebnis aus %1 wird berechnet: %2 · %3 s</translation>
    </message>
    <message>
        <source>✕ No readings from the skin: check cable, power and address</source>
        <translation>✕ Keine Messwerte von der Haut: Kabel, Stromversorgung und Adresse prüfen</translation>
    </message>
    <message>
        <source>✕ No readings</source>
        <translation>✕ Keine Messwerte</translation>
    </message>
    <message>
        <source>● Live: the readings of this moment, not the result</source>
        <translation>● Live: die Messwerte dieses Augenblicks, nicht das Ergebnis</translation>
    </message>
    <message>
        <source>● Live</source>
        <translation>● Live</translation>
    </message>
    <message>
        <source>from before: %1</source>
        <translation>von vorher: %1</translation>
    </message>
    <message>
        <source>preliminary: not fully checked yet, without uncertainty</source>
        <translation>vorläufig: noch nicht fertig geprüft, ohne Unsicherheit</translation>
    </message>
    <message>
        <source>preliminary</source>
        <translation>vorläufig</translation>
    </message>
</context>
<context>
    <name>hexoderm::MeasureTool</name>
    <message>
        <source>Measure: pick the first cell (Esc ends)</source>
        <translation>Messen: die erste Zelle wählen (Esc beendet)</translation>
    </message>
    <message>
        <source>Measure from cell %1: pick the second cell (Esc ends)</source>
        <translation>Messen ab Zelle %1: die zweite Zelle wählen (Esc beendet)</translation>
    </message>
</context>
<context>
    <name>hexoderm::Message</name>
    <message>
        <source>Capturing what there is, moved or not</source>
        <translation>Aufnahme läuft, bewegt oder nicht</translation>
    </message>
    <message>
        <source>Keep still: taking samples</source>
        <translation>Weiter stillhalten: Messung läuft</translation>
    </message>
    <message>
        <source>Still</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>Still: ready to capture</source>
        <translation>Ruhig: bereit zur Aufnahme</translation>
    </message>
    <message>
        <source>Cell {} is dead: it reads {}, no gravity</source>
        <translation>Zelle {} ist tot: Sie misst {}, keine Schwerkraft</translation>
    </message>
    <message>
        <source>Cell {} is stuck: it repeated one reading while the part moved</source>
        <translation>Zelle {} hängt: Sie wiederholte einen Messwert, während sich das Teil bewegte</translation>
    </message>
    <message>
        <source>Cell {} is noisy: it scatters by {} rms while the rest is still</source>
        <translation>Zelle {} rauscht: Sie streut um {} (Effektivwert), während der Rest ruht</translation>
    </message>
    <message>
        <source>Cell {} is restless: it turns by {} deg/s while the rest is still</source>
        <translation>Zelle {} ist unruhig: Sie dreht sich mit {}°/s, während der Rest ruht</translation>
    </message>
    <message>
        <source>Waiting for samples</source>
        <translation>Wartet auf Messwerte</translation>
    </message>
    <message>
        <source>Waiting for samples: all cells are silent</source>
        <translation>Wartet auf Messwerte: Alle Zellen schweigen</translation>
    </message>
    <message>
        <source>Hold still: the readings scatter too much to tell whether the part turns</source>
        <translation>Stillhalten: Die Messwerte streuen zu stark, um zu erkennen, ob sich das Teil dreht</translation>
    </message>
    <message>
        <source>Waiting for samples: fewer than {} s so far</source>
        <translation>Wartet auf Messwerte: bisher weniger als {} s</translation>
    </message>
    <message>
        <source>Turn the part: it has moved {} deg since the last capture, more than {} are needed</source>
        <translation>Teil drehen: seit der letzten Aufnahme um {}° bewegt, mehr als {}° sind nötig</translation>
    </message>
    <message>
        <source>Hold still: the part turns by {} deg/s, limit {}</source>
        <translation>Stillhalten: Das Teil dreht sich mit {}°/s, Grenze {}</translation>
    </message>
    <message>
        <source>Hold still: cell {} moves {} mg, limit {}</source>
        <translation>Stillhalten: Zelle {} bewegt sich um {} mg, Grenze {}</translation>
    </message>
    <message>
        <source>Hold still: cell {} turns by {} deg/s against the rest, limit {}</source>
        <translation>Stillhalten: Zelle {} dreht sich mit {}°/s gegen die anderen, Grenze {}</translation>
    </message>
    <message>
        <source>Simulated {} on {}, link law {}, seed {}, on a robot with its motors on</source>
        <translation>Simulierte Haut {} auf {}, Verbindungsgesetz {}, Startwert {}, an einem Roboter mit laufenden Motoren</translation>
    </message>
    <message>
        <source>Simulated {} on {}, link law {}, seed {}</source>
        <translation>Simulierte Haut {} auf {}, Verbindungsgesetz {}, Startwert {}</translation>
    </message>
    <message>
        <source>Streaming: {}</source>
        <translation>Empfang: {}</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected one of {}</source>
        <translation>Quelle „{}“: erwartet ist eines von {}</translation>
    </message>
    <message>
        <source>is cut off; all before byte {} was played</source>
        <translation>ist abgeschnitten; alles vor Byte {} wurde abgespielt</translation>
    </message>
    <message>
        <source>is a folder, expected a recording</source>
        <translation>ist ein Ordner, erwartet wurde eine Aufzeichnung</translation>
    </message>
    <message>
        <source>can&apos;t be read: {}</source>
        <translation>ist nicht lesbar: {}</translation>
    </message>
    <message>
        <source>this recording has version {}, this program reads version {}</source>
        <translation>diese Aufzeichnung hat Version {}, dieses Programm liest Version {}</translation>
    </message>
    <message>
        <source>byte {}: a record says that it has {} bytes, at most {} were expected; the rest can&apos;t be read</source>
        <translation>Byte {}: ein Eintrag gibt an, {} Bytes zu haben, erwartet wurden höchstens {}; der Rest ist nicht lesbar</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>wird abgespielt</translation>
    </message>
    <message>
        <source>the recording is over</source>
        <translation>die Aufzeichnung ist zu Ende</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>its cell model can&apos;t be used: {}</source>
        <translation>sein Zellmodell ist nicht verwendbar: {}</translation>
    </message>
    <message>
        <source>it has not said what it is</source>
        <translation>es hat noch nicht gesagt, was es ist</translation>
    </message>
    <message>
        <source>its topology has not come</source>
        <translation>seine Topologie ist noch nicht da</translation>
    </message>
    <message>
        <source>the device</source>
        <translation>dem Gerät</translation>
    </message>
    <message>
        <source>what came is broken: {}</source>
        <translation>was kam, ist kaputt: {}</translation>
    </message>
    <message>
        <source>the input is over</source>
        <translation>die Eingabe ist zu Ende</translation>
    </message>
    <message>
        <source>nothing comes</source>
        <translation>es kommt nichts</translation>
    </message>
    <message>
        <source>waiting for the device, {}</source>
        <translation>wartet auf das Gerät, {}</translation>
    </message>
    <message>
        <source>connected to {}</source>
        <translation>verbunden mit {}</translation>
    </message>
    <message>
        <source>standard input takes no commands</source>
        <translation>die Standardeingabe nimmt keine Befehle an</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected {}</source>
        <translation>Quelle „{}“: erwartet ist {}</translation>
    </message>
    <message>
        <source>{}, the port from 1 to 65535 (for example {})</source>
        <translation>{}, Port von 1 bis 65535 (zum Beispiel {})</translation>
    </message>
    <message>
        <source>{} or {} (for example {})</source>
        <translation>{} oder {} (zum Beispiel {})</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>Verbindung wird aufgebaut</translation>
    </message>
    <message>
        <source>{}; not trying again</source>
        <translation>{}; kein weiterer Versuch</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>die Verbindung wurde geschlossen</translation>
    </message>
    <message>
        <source>connected to the device, {}</source>
        <translation>mit dem Gerät verbunden, {}</translation>
    </message>
    <message>
        <source>{}; it says: {}</source>
        <translation>{}; es sagt: {}</translation>
    </message>
    <message>
        <source>{}; next try in {}</source>
        <translation>{}; nächster Versuch in {}</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>die Verbindung ging verloren</translation>
    </message>
    <message>
        <source>the device did not answer within {}</source>
        <translation>das Gerät hat innerhalb von {} nicht geantwortet</translation>
    </message>
    <message>
        <source>the source was stopped</source>
        <translation>die Quelle wurde angehalten</translation>
    </message>
    <message>
        <source>Host not found (authoritative)</source>
        <translation>Rechner nicht gefunden</translation>
    </message>
    <message>
        <source>the device closed the connection</source>
        <translation>das Gerät hat die Verbindung beendet</translation>
    </message>
    <message>
        <source>the host is not known: {}</source>
        <translation>der Rechner ist nicht bekannt: {}</translation>
    </message>
    <message>
        <source>cell {} port {}</source>
        <translation>Zelle {} Port {}</translation>
    </message>
    <message>
        <source>A cell carries the ID 0, which means &quot;no neighbour&quot;; it is left out.</source>
        <translation>Eine Zelle trägt die ID 0, die „kein Nachbar“ bedeutet; sie wird weggelassen.</translation>
    </message>
    <message>
        <source>Cell {} is listed more than once; only the first entry counts.</source>
        <translation>Zelle {} ist mehrfach aufgeführt; nur der erste Eintrag zählt.</translation>
    </message>
    <message>
        <source>The neighbour at {} is reported more than once; it counts once.</source>
        <translation>Der Nachbar an {} ist mehrfach gemeldet; er zählt einmal.</translation>
    </message>
    <message>
        <source>Cell {} reports two different neighbours at port {}: cells {} and {}. Neither link is used.</source>
        <translation>Zelle {} meldet an Port {} zwei verschiedene Nachbarn: die Zellen {} und {}. Keine der beiden Verbindungen wird benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reports a neighbour at port {}, but cell model {} has no such port. The link is not used.</source>
        <translation>Zelle {} meldet einen Nachbarn an Port {}, aber das Zellmodell {} hat diesen Port nicht. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>A computer interface (ID {}) is connected at {}.</source>
        <translation>Eine Rechnerschnittstelle (ID {}) ist an {} angeschlossen.</translation>
    </message>
    <message>
        <source>Cell {} reports itself as its neighbour at port {}. The link is not used.</source>
        <translation>Zelle {} meldet sich an Port {} selbst als Nachbarn. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reports cell {} at port {}, but no such cell was found. The link is not used.</source>
        <translation>Zelle {} meldet Zelle {} an Port {}, aber eine solche Zelle wurde nicht gefunden. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reports port {} of cell {}, but cell model {} has no such port. The link is not used.</source>
        <translation>Zelle {} meldet Port {} von Zelle {}, aber das Zellmodell {} hat diesen Port nicht. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reports cell {} at port {}, but cell {} does not report it back. The link is not used.</source>
        <translation>Zelle {} meldet Zelle {} an Port {}, aber Zelle {} meldet das nicht zurück. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Only cell {} reports the {}; cell {} does not report it back. The link is not used.</source>
        <translation>Nur Zelle {} meldet die {}; Zelle {} meldet sie nicht zurück. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reports {} at its port {}, but that port reports {}. Neither link is used.</source>
        <translation>Zelle {} meldet {} an ihrem Port {}, aber dieser Port meldet {}. Keine der beiden Verbindungen wird benutzt.</translation>
    </message>
    <message>
        <source>cell {}</source>
        <translation>Zelle {}</translation>
    </message>
    <message>
        <source>Cells {} and {} report each other at more than one port without naming the other side&apos;s; it can&apos;t be told which ports belong together. No link between them is used.</source>
        <translation>Die Zellen {} und {} melden einander an mehr als einem Port, ohne den Port der Gegenseite zu nennen; welche Ports zusammengehören, lässt sich nicht sagen. Keine Verbindung zwischen ihnen wird benutzt.</translation>
    </message>
    <message>
        <source>The {} joins ports that cell model {} forbids to join. It is not used.</source>
        <translation>Die {} verbindet Ports, die das Zellmodell {} nicht zu verbinden erlaubt. Sie wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cells {} and {} are joined {} times, which two hexagons can&apos;t be. None of these links is used.</source>
        <translation>Die Zellen {} und {} sind {}-mal verbunden, was zwei Sechsecke nicht sein können. Keine dieser Verbindungen wird benutzt.</translation>
    </message>
    <message>
        <source>The {} joins {} and {}; the patch ends there.</source>
        <translation>Die {} verbindet {} und {}; dort endet das Hautstück.</translation>
    </message>
    <message>
        <source>link {} port {} - {} port {}</source>
        <translation>Verbindung {} Port {} – {} Port {}</translation>
    </message>
    <message>
        <source>cannot be written: {}</source>
        <translation>lässt sich nicht schreiben: {}</translation>
    </message>
    <message>
        <source>cannot be replaced: {}</source>
        <translation>lässt sich nicht ersetzen: {}</translation>
    </message>
    <message>
        <source>is a folder, cannot be written as a file</source>
        <translation>ist ein Ordner und lässt sich nicht als Datei schreiben</translation>
    </message>
    <message>
        <source>is a file, expected a folder</source>
        <translation>ist eine Datei, erwartet ist ein Ordner</translation>
    </message>
    <message>
        <source>read back after writing, it holds other bytes than were written</source>
        <translation>nach dem Schreiben zurückgelesen, enthält sie andere Bytes, als geschrieben wurden</translation>
    </message>
    <message>
        <source>skin graph for Graphviz, with ports and quality</source>
        <translation>Hautgraph für Graphviz, mit Ports und Güte</translation>
    </message>
    <message>
        <source>mesh of the cells in metres, coloured by quality</source>
        <translation>Netz der Zellen in Metern, nach Güte gefärbt</translation>
    </message>
    <message>
        <source>mesh of the cells for CAD, in millimetres or metres</source>
        <translation>Netz der Zellen für CAD, in Millimetern oder Metern</translation>
    </message>
    <message>
        <source>everything about the cells and sensors for ParaView and VTK, lossless</source>
        <translation>alles über Zellen und Sensoren für ParaView und VTK, verlustfrei</translation>
    </message>
    <message>
        <source>there are no cells, and so nothing to draw in a {} file: export csv, dot, vtp or urdf instead</source>
        <translation>es gibt keine Zellen und damit in einer {}-Datei nichts zu zeichnen: stattdessen csv, dot, vtp oder urdf exportieren</translation>
    </message>
    <message>
        <source>expected a Hexoderm session (*.hexo, or format &quot;{}&quot;), a calibration (format &quot;{}&quot;) or a TUM SkinConfig XML</source>
        <translation>erwartet ist eine Hexoderm-Sitzung (*.hexo oder Format „{}“), eine Kalibrierung (Format „{}“) oder ein TUM-SkinConfig-XML</translation>
    </message>
    <message>
        <source>is a recording, which is not opened but played: connect to it as replay:FILE</source>
        <translation>ist eine Aufzeichnung, die nicht geöffnet, sondern abgespielt wird: als replay:DATEI verbinden</translation>
    </message>
    <message>
        <source>the file is empty, {}</source>
        <translation>die Datei ist leer, {}</translation>
    </message>
    <message>
        <source>is none of the files that Hexoderm reads, {}</source>
        <translation>ist keine der Dateien, die Hexoderm liest, {}</translation>
    </message>
    <message>
        <source>The {} joins cells that the file places in different frames (root cells {} and {}); the patch ends there.</source>
        <translation>Die {} verbindet Zellen, die in der Datei in verschiedenen Koordinatensystemen liegen (Wurzelzellen {} und {}); dort endet das Hautstück.</translation>
    </message>
    <message>
        <source>Imported placements; nothing was measured here.</source>
        <translation>Eingelesene Lagen; hier wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>Check the findings, then export, or take poses of this skin to measure it.</source>
        <translation>Die Befunde prüfen, dann exportieren, oder Posen dieser Haut aufnehmen, um sie zu vermessen.</translation>
    </message>
    <message>
        <source>Turn the part so that cell {} faces the ceiling.</source>
        <translation>Das Teil so drehen, dass Zelle {} zur Decke zeigt.</translation>
    </message>
    <message>
        <source>Turn the part so that cell {} faces the floor.</source>
        <translation>Das Teil so drehen, dass Zelle {} zum Boden zeigt.</translation>
    </message>
    <message>
        <source>Turn the part so that cell {} faces a wall, its side towards the ceiling.</source>
        <translation>Das Teil so drehen, dass Zelle {} zur Wand zeigt, mit einer Kante zur Decke.</translation>
    </message>
    <message>
        <source>facing ceiling</source>
        <translation>zur Decke</translation>
    </message>
    <message>
        <source>facing floor</source>
        <translation>zum Boden</translation>
    </message>
    <message>
        <source>facing wall, {} up</source>
        <translation>zur Wand, {} oben</translation>
    </message>
    <message>
        <source>tilted up, {} up</source>
        <translation>aufwärts, {} oben</translation>
    </message>
    <message>
        <source>tilted down, {} up</source>
        <translation>abwärts, {} oben</translation>
    </message>
    <message>
        <source>cells {}</source>
        <translation>Zellen {}</translation>
    </message>
    <message>
        <source>{} cells</source>
        <translation>{} Zellen</translation>
    </message>
    <message>
        <source>Every link joins two ports that fit</source>
        <translation>An jeder Verbindung passen beide Ports zusammen</translation>
    </message>
    <message>
        <source>{} of {} links are kept out: see the findings</source>
        <translation>{} von {} Verbindungen bleiben außen vor: siehe Befunde</translation>
    </message>
    <message>
        <source>Nothing comes from {}</source>
        <translation>Nichts kommt von {}</translation>
    </message>
    <message>
        <source>The cell sends</source>
        <translation>Die Zelle sendet</translation>
    </message>
    <message>
        <source>All {} cells send</source>
        <translation>Alle {} Zellen senden</translation>
    </message>
    <message>
        <source>Found: {}</source>
        <translation>Gefunden: {}</translation>
    </message>
    <message>
        <source>The skin has no cells</source>
        <translation>Die Haut hat keine Zellen</translation>
    </message>
    <message>
        <source>No readings have come yet</source>
        <translation>Noch sind keine Messwerte da</translation>
    </message>
    <message>
        <source>Every cell sends</source>
        <translation>Jede Zelle sendet</translation>
    </message>
    <message>
        <source>{} of {} cells send</source>
        <translation>{} von {} Zellen senden</translation>
    </message>
    <message>
        <source>±{}, ±{}</source>
        <translation>±{} und ±{}</translation>
    </message>
    <message>
        <source>The skin has no cells.</source>
        <translation>Die Haut hat keine Zellen.</translation>
    </message>
    <message>
        <source>Check the connection to the skin and explore it again.</source>
        <translation>Die Verbindung zur Haut prüfen und sie neu erkunden.</translation>
    </message>
    <message>
        <source>One cell: it is its own origin, there is nothing to estimate.</source>
        <translation>Eine Zelle: Sie ist ihr eigener Ursprung, zu schätzen gibt es nichts.</translation>
    </message>
    <message>
        <source>Export.</source>
        <translation>Exportieren.</translation>
    </message>
    <message>
        <source>1 pose</source>
        <translation>1 Pose</translation>
    </message>
    <message>
        <source>{} poses</source>
        <translation>{} Posen</translation>
    </message>
    <message>
        <source>Hold the part still and take a first pose.</source>
        <translation>Das Teil stillhalten und eine erste Pose aufnehmen.</translation>
    </message>
    <message>
        <source>Look at the findings, then export.</source>
        <translation>Die Befunde ansehen, dann exportieren.</translation>
    </message>
    <message>
        <source>in pose {}</source>
        <translation>in Pose {}</translation>
    </message>
    <message>
        <source>in poses {}</source>
        <translation>in den Posen {}</translation>
    </message>
    <message>
        <source>Cell {} delivered no reading in any pose; it is placed through its links.</source>
        <translation>Zelle {} hat in keiner Pose einen Messwert geliefert; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} delivered no reading {}; it is placed from the other poses.</source>
        <translation>Zelle {} hat {} keinen Messwert geliefert; sie wird aus den anderen Posen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads {} on its {} axis in all poses, while what it reads in all ranges from {} to {}: the axis is dead. The cell is placed through its links.</source>
        <translation>Zelle {0} misst auf ihrer {2}-Achse in allen Posen {1}, insgesamt aber zwischen {3} und {4}: Die Achse ist tot. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads the end of its range ({} g) {}; these readings are not used.</source>
        <translation>Zelle {0} misst {2} das Ende ihres Messbereichs ({1} g); diese Messwerte werden nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reads less than {} {}: its accelerometer is dead. The cell is placed through its links.</source>
        <translation>Zelle {0} misst {2} weniger als {1}: Ihr Beschleunigungssensor ist tot. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads less than {} {}; these readings are not used.</source>
        <translation>Zelle {0} misst {2} weniger als {1}; diese Messwerte werden nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reads up to {} {}, expected {} +- {}; these readings are not used.</source>
        <translation>Zelle {0} misst {2} bis zu {1}, erwartet sind {3} ± {4}; diese Messwerte werden nicht benutzt.</translation>
    </message>
    <message>
        <source>In pose {} the readings of most cells scatter by {}: the part was probably moving. Take the pose again.</source>
        <translation>In Pose {} streuen die Messwerte der meisten Zellen um {}: Wahrscheinlich hat sich das Teil bewegt. Die Pose noch einmal aufnehmen.</translation>
    </message>
    <message>
        <source>Cell {} scatters by {} in pose {} (other cells {}, limit {}); the reading is not used.</source>
        <translation>Zelle {0} streut in Pose {2} um {1} (andere Zellen {3}, Grenze {4}); der Messwert wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reads the same direction in all poses (within {} degrees) while the other cells turn by {} degrees: its accelerometer is stuck. The cell is placed through its links.</source>
        <translation>Zelle {} misst in allen Posen dieselbe Richtung (auf {} Grad genau), während sich die anderen Zellen um {} Grad drehen: Ihr Beschleunigungssensor hängt. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>In pose {} most neighbouring cells contradict each other, and without it they don&apos;t: the part probably moved while it was sampled. The pose is not used; take it again.</source>
        <translation>In Pose {} widersprechen sich die meisten Nachbarzellen, ohne sie nicht: Wahrscheinlich hat sich das Teil während der Messung bewegt. Die Pose wird nicht benutzt; noch einmal aufnehmen.</translation>
    </message>
    <message>
        <source>The {} was set aside by hand; it is not used.</source>
        <translation>Die {} wurde von Hand ausgeschlossen; sie wird nicht benutzt.</translation>
    </message>
    <message>
        <source>The {} was set aside by hand, but the skin reports no such link.</source>
        <translation>Die {} wurde von Hand ausgeschlossen, aber die Haut meldet keine solche Verbindung.</translation>
    </message>
    <message>
        <source>The {} was set aside by hand ({}); it is not used.</source>
        <translation>Die {} wurde von Hand ausgeschlossen ({}); sie wird nicht benutzt.</translation>
    </message>
    <message>
        <source>The {} was set aside by hand ({}), but the skin reports no such link.</source>
        <translation>Die {} wurde von Hand ausgeschlossen ({}), aber die Haut meldet keine solche Verbindung.</translation>
    </message>
    <message>
        <source>Cell {} was left out; it is placed through its links.</source>
        <translation>Zelle {} wurde weggelassen; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>The cells of the {} moved against each other between poses (misfit {} standard deviations, limit {}): probably a joint or a cable, or one of the two sensors is bad. The link is not used.</source>
        <translation>Die Zellen der {} haben sich zwischen den Posen gegeneinander bewegt (Abweichung {} Standardabweichungen, Grenze {}): wahrscheinlich ein Gelenk oder ein Kabel, oder einer der beiden Sensoren ist schlecht. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Cell {} reads {} g on average where there is 1 g, and does not fit its neighbours: its gain is wrong. The cell is placed through its links.</source>
        <translation>Zelle {} misst im Mittel {} g, wo 1 g ist, und passt nicht zu ihren Nachbarn: Ihre Verstärkung ist falsch. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads what fits none of the other cells, however it lies: its accelerometer is wrongly wired or broken, or its one link is not rigid. The cell is placed through its links.</source>
        <translation>Was Zelle {} misst, passt zu keiner anderen Zelle, wie auch immer sie liegt: Ihr Beschleunigungssensor ist falsch verdrahtet oder defekt, oder ihre einzige Verbindung ist nicht starr. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads what fits none of the other cells, however it lies: its accelerometer is wrongly wired or broken. The cell is placed through its links.</source>
        <translation>Was Zelle {} misst, passt zu keiner anderen Zelle, wie auch immer sie liegt: Ihr Beschleunigungssensor ist falsch verdrahtet oder defekt. Die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Pose {} is pose {} upside down (within {}), which adds no new direction.</source>
        <translation>Pose {} ist Pose {} auf dem Kopf (auf {} genau); das bringt keine neue Richtung.</translation>
    </message>
    <message>
        <source>Pose {} shows gravity where pose {} does (within {}), which adds no new direction.</source>
        <translation>Pose {} zeigt die Schwerkraft dort, wo Pose {} sie zeigt (auf {} genau); das bringt keine neue Richtung.</translation>
    </message>
    <message>
        <source>There is no pose yet: the shape shown follows from the ports alone.</source>
        <translation>Es gibt noch keine Pose: Die gezeigte Form folgt allein aus den Ports.</translation>
    </message>
    <message>
        <source>Two poses carry the number {}; both are used.</source>
        <translation>Zwei Posen tragen die Nummer {}; beide werden benutzt.</translation>
    </message>
    <message>
        <source>Pose {} holds a reading of cell {}, which is not in the skin.</source>
        <translation>Pose {} enthält einen Messwert von Zelle {}, die nicht zur Haut gehört.</translation>
    </message>
    <message>
        <source>Pose {} holds two readings of cell {}; the first counts.</source>
        <translation>Pose {} enthält zwei Messwerte von Zelle {}; der erste zählt.</translation>
    </message>
    <message>
        <source>In pose {} the cells contradict each other by {} times their noise (other poses {}): the part probably moved while it was sampled. Take the pose again.</source>
        <translation>In Pose {} widersprechen sich die Zellen um das {}-Fache ihres Rauschens (andere Posen {}): Wahrscheinlich hat sich das Teil während der Messung bewegt. Die Pose noch einmal aufnehmen.</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>{} links</source>
        <translation>{} Verbindungen</translation>
    </message>
    <message>
        <source>1 patch</source>
        <translation>1 Hautstück</translation>
    </message>
    <message>
        <source>{} patches</source>
        <translation>{} Hautstücke</translation>
    </message>
    <message>
        <source>the file is damaged: expected entry {}</source>
        <translation>die Datei ist beschädigt: erwartet ist Eintrag {}</translation>
    </message>
    <message>
        <source>the file is damaged: what it holds does not match its digest</source>
        <translation>die Datei ist beschädigt: Ihr Inhalt passt nicht zu ihrer Prüfsumme</translation>
    </message>
    <message>
        <source>a session holds at most {} poses</source>
        <translation>eine Sitzung fasst höchstens {} Posen</translation>
    </message>
    <message>
        <source>exists already, and what a session has captured is never replaced: take another name, or remove the file first</source>
        <translation>gibt es schon, und was eine Sitzung aufgenommen hat, wird nie ersetzt: anderen Namen wählen oder die Datei vorher entfernen</translation>
    </message>
    <message>
        <source>the file is damaged: they are missing</source>
        <translation>die Datei ist beschädigt: sie fehlen</translation>
    </message>
    <message>
        <source>the file is damaged: they do not match their digest</source>
        <translation>die Datei ist beschädigt: sie passen nicht zu ihrer Prüfsumme</translation>
    </message>
    <message>
        <source>is open for reading only: save the session elsewhere to go on</source>
        <translation>ist nur zum Lesen offen: die Sitzung woanders speichern, um weiterzuarbeiten</translation>
    </message>
    <message>
        <source>cannot be written ({}): make the file and its folder writable, or save the session elsewhere</source>
        <translation>lässt sich nicht schreiben ({}): Datei und Ordner beschreibbar machen oder die Sitzung woanders speichern</translation>
    </message>
    <message>
        <source>cannot be opened: {}</source>
        <translation>lässt sich nicht öffnen: {}</translation>
    </message>
    <message>
        <source>another program is writing to it: close that program and try again</source>
        <translation>ein anderes Programm schreibt darin: das Programm schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>the file ends in the middle (truncated?), expected a whole Hexoderm session</source>
        <translation>die Datei endet mittendrin (abgeschnitten?), erwartet ist eine vollständige Hexoderm-Sitzung</translation>
    </message>
    <message>
        <source>the disk does not read or write it ({}): check the disk and try again; what was stored before is kept as far as the disk has it</source>
        <translation>der Datenträger liest oder schreibt sie nicht ({}): den Datenträger prüfen und noch einmal versuchen; was vorher gespeichert war, bleibt, soweit der Datenträger es hat</translation>
    </message>
    <message>
        <source>is not a Hexoderm session, expected an SQLite database (*.hexo)</source>
        <translation>ist keine Hexoderm-Sitzung, erwartet ist eine SQLite-Datenbank (*.hexo)</translation>
    </message>
    <message>
        <source>the file is damaged, expected the database of a Hexoderm session ({})</source>
        <translation>die Datei ist beschädigt, erwartet ist die Datenbank einer Hexoderm-Sitzung ({})</translation>
    </message>
    <message>
        <source>is a folder, expected a file</source>
        <translation>ist ein Ordner, erwartet ist eine Datei</translation>
    </message>
    <message>
        <source>is not a file, expected one</source>
        <translation>ist keine Datei, erwartet ist eine</translation>
    </message>
    <message>
        <source>the file is empty, expected a Hexoderm session</source>
        <translation>die Datei ist leer, erwartet ist eine Hexoderm-Sitzung</translation>
    </message>
    <message>
        <source>no copy can be made to read it: {}</source>
        <translation>zum Lesen lässt sich keine Kopie anlegen: {}</translation>
    </message>
    <message>
        <source>cannot be written: {}; make the file writable, or open it for reading and save it elsewhere</source>
        <translation>lässt sich nicht schreiben: {}; die Datei beschreibbar machen, oder sie zum Lesen öffnen und woanders speichern</translation>
    </message>
    <message>
        <source>another Hexoderm has it open for writing: close it there, or open it for reading</source>
        <translation>ein anderes Hexoderm hat sie zum Schreiben offen: dort schließen oder zum Lesen öffnen</translation>
    </message>
    <message>
        <source>another Hexoderm is reading it: wait until it has done and try again</source>
        <translation>ein anderes Hexoderm liest sie: warten, bis es fertig ist, und noch einmal versuchen</translation>
    </message>
    <message>
        <source>cannot be locked against a second writer: {}; keep sessions on a disk of this machine</source>
        <translation>lässt sich nicht gegen einen zweiten Schreiber sperren: {}; Sitzungen auf einem Datenträger dieses Rechners halten</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>its file system can&apos;t keep a journal (WAL): keep sessions on a disk of this machine</source>
        <translation>ihr Dateisystem kann kein Journal (WAL) führen: Sitzungen auf einem Datenträger dieses Rechners halten</translation>
    </message>
    <message>
        <source>A cell ID is listed twice; the first entry counts.</source>
        <translation>Eine Zell-ID ist zweimal aufgeführt; der erste Eintrag zählt.</translation>
    </message>
    <message>
        <source>A cell carries ID 0 or an interface&apos;s ID; it is left out.</source>
        <translation>Eine Zelle trägt die ID 0 oder die einer Schnittstelle; sie wird weggelassen.</translation>
    </message>
    <message>
        <source>A link names a port that the cell model does not have; it is left out.</source>
        <translation>Eine Verbindung nennt einen Port, den das Zellmodell nicht hat; sie wird weggelassen.</translation>
    </message>
    <message>
        <source>A link names a neighbour that is not in the list of cells; it is left out.</source>
        <translation>Eine Verbindung nennt einen Nachbarn, der nicht in der Liste der Zellen steht; sie wird weggelassen.</translation>
    </message>
    <message>
        <source>A cell names itself as its neighbour; the link is left out.</source>
        <translation>Eine Zelle nennt sich selbst als Nachbarn; die Verbindung wird weggelassen.</translation>
    </message>
    <message>
        <source>Only one of two cells reports the link; it is muted.</source>
        <translation>Nur eine von zwei Zellen meldet die Verbindung; sie ist ausgeschlossen.</translation>
    </message>
    <message>
        <source>The reports of two cells about a link disagree; the links concerned are muted.</source>
        <translation>Zwei Zellen melden eine Verbindung verschieden; die betroffenen Verbindungen sind ausgeschlossen.</translation>
    </message>
    <message>
        <source>The same port is reported more than once, or two cells are joined twice.</source>
        <translation>Derselbe Port ist mehrfach gemeldet, oder zwei Zellen sind doppelt verbunden.</translation>
    </message>
    <message>
        <source>A link joins two ports that the cell model forbids to join; it is muted.</source>
        <translation>Eine Verbindung verbindet zwei Ports, die das Zellmodell nicht zu verbinden erlaubt; sie ist ausgeschlossen.</translation>
    </message>
    <message>
        <source>A cell is connected to a computer interface; the edge is not part of the skin.</source>
        <translation>Eine Zelle ist an eine Rechnerschnittstelle angeschlossen; diese Kante gehört nicht zur Haut.</translation>
    </message>
    <message>
        <source>A link joins cells of different body parts; it is muted, and the patch ends there.</source>
        <translation>Eine Verbindung verbindet Zellen verschiedener Körperteile; sie ist ausgeschlossen, und das Hautstück endet dort.</translation>
    </message>
    <message>
        <source>A link bends further than a skin link can; it is probably a cable or crosses a joint.</source>
        <translation>Eine Verbindung biegt sich weiter, als eine Hautverbindung kann; wahrscheinlich ist sie ein Kabel oder führt über ein Gelenk.</translation>
    </message>
    <message>
        <source>A link twists further than a skin link can; it is probably a cable or a wrong port.</source>
        <translation>Eine Verbindung verwindet sich weiter, als eine Hautverbindung kann; wahrscheinlich ist sie ein Kabel, oder ein Port ist falsch.</translation>
    </message>
    <message>
        <source>A link is turned in the surface further than a skin link can be; probably a wrong port or a cable.</source>
        <translation>Eine Verbindung ist in der Fläche weiter gedreht, als eine Hautverbindung sein kann; wahrscheinlich ein falscher Port oder ein Kabel.</translation>
    </message>
    <message>
        <source>The two cells of a link moved against each other between poses; it is probably a joint.</source>
        <translation>Die beiden Zellen einer Verbindung haben sich zwischen den Posen gegeneinander bewegt; wahrscheinlich ist dort ein Gelenk.</translation>
    </message>
    <message>
        <source>With all other links the ends of this link come to lie far apart: it is probably a cable, or another link of the loop is. Muted.</source>
        <translation>Mit allen anderen Verbindungen liegen die Enden dieser Verbindung weit auseinander: Wahrscheinlich ist sie oder eine andere Verbindung der Schleife ein Kabel. Ausgeschlossen.</translation>
    </message>
    <message>
        <source>The operator set a link aside, as a cable for example; it is muted.</source>
        <translation>Eine Verbindung wurde von Hand ausgeschlossen, als Kabel zum Beispiel; sie wird nicht benutzt.</translation>
    </message>
    <message>
        <source>A cell has no usable reading in any enabled pose; it is placed through its links.</source>
        <translation>Eine Zelle hat in keiner benutzten Pose einen brauchbaren Messwert; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell has no reading in some enabled poses; it is placed from the others.</source>
        <translation>Eine Zelle hat in einigen benutzten Posen keinen Messwert; sie wird aus den anderen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s accelerometer reads nothing like gravity; the cell is placed through its links.</source>
        <translation>Der Beschleunigungssensor einer Zelle misst nichts, was Schwerkraft sein könnte; die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s accelerometer does not change while the part moves; the cell is placed through its links.</source>
        <translation>Der Beschleunigungssensor einer Zelle ändert sich nicht, während sich das Teil bewegt; die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A reading lies at the end of the accelerometer&apos;s range; it is not used.</source>
        <translation>Ein Messwert liegt am Ende des Messbereichs; er wird nicht benutzt.</translation>
    </message>
    <message>
        <source>A cell&apos;s readings scatter far more than its sensor&apos;s noise and the other cells&apos;.</source>
        <translation>Die Messwerte einer Zelle streuen weit mehr als das Rauschen ihres Sensors und das der anderen Zellen.</translation>
    </message>
    <message>
        <source>A cell&apos;s readings are further from 1 g than its sensor&apos;s offset and scale allow.</source>
        <translation>Die Messwerte einer Zelle liegen weiter von 1 g weg, als Nullpunkt und Skalierung ihres Sensors erlauben.</translation>
    </message>
    <message>
        <source>One axis of a cell&apos;s accelerometer does not follow gravity; the cell is placed through its links.</source>
        <translation>Eine Achse des Beschleunigungssensors einer Zelle folgt der Schwerkraft nicht; die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s accelerometer reads too much or too little in every pose; it is placed by its links.</source>
        <translation>Der Beschleunigungssensor einer Zelle misst in jeder Pose zu viel oder zu wenig; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s readings fit no position of the cell in the patch; the cell is placed through its links.</source>
        <translation>Die Messwerte einer Zelle passen zu keiner Lage der Zelle im Hautstück; die Zelle wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell was left out on request; it is placed through its links.</source>
        <translation>Eine Zelle wurde auf Wunsch weggelassen; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A pose holds a reading of a cell that is not in the skin; it is not used.</source>
        <translation>Eine Pose enthält einen Messwert einer Zelle, die nicht zur Haut gehört; er wird nicht benutzt.</translation>
    </message>
    <message>
        <source>A pose holds two readings of one cell; the first counts.</source>
        <translation>Eine Pose enthält zwei Messwerte einer Zelle; der erste zählt.</translation>
    </message>
    <message>
        <source>Two poses carry the same ID.</source>
        <translation>Zwei Posen tragen dieselbe Nummer.</translation>
    </message>
    <message>
        <source>There is no enabled pose: the placement follows from the ports alone.</source>
        <translation>Es gibt keine benutzte Pose: Die Anordnung folgt allein aus den Ports.</translation>
    </message>
    <message>
        <source>The poses show gravity along too few directions to fix every rotation.</source>
        <translation>Die Posen zeigen die Schwerkraft aus zu wenigen Richtungen, um jede Drehung festzulegen.</translation>
    </message>
    <message>
        <source>Two poses show gravity along nearly the same line, which adds little.</source>
        <translation>Zwei Posen zeigen die Schwerkraft fast entlang derselben Linie; das bringt wenig.</translation>
    </message>
    <message>
        <source>Most cells scattered far beyond their noise in this pose: the part was probably moving.</source>
        <translation>Die meisten Zellen streuten in dieser Pose weit über ihr Rauschen hinaus: Wahrscheinlich hat sich das Teil bewegt.</translation>
    </message>
    <message>
        <source>The cells contradict each other in one pose far more than in the others; the part moved.</source>
        <translation>Die Zellen widersprechen sich in einer Pose weit mehr als in den anderen; das Teil hat sich bewegt.</translation>
    </message>
    <message>
        <source>the file is empty, expected JSON</source>
        <translation>die Datei ist leer, erwartet ist JSON</translation>
    </message>
    <message>
        <source>expected a finite number, found {}</source>
        <translation>erwartet ist eine endliche Zahl, gefunden wurde {}</translation>
    </message>
    <message>
        <source>the file ends in the middle (truncated?), expected complete JSON</source>
        <translation>die Datei endet mittendrin (abgeschnitten?), erwartet ist vollständiges JSON</translation>
    </message>
    <message>
        <source>this is not JSON, expected a JSON value here</source>
        <translation>das ist kein JSON, erwartet ist hier ein JSON-Wert</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Ist kein Ordner</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Kein solches Gerät</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät ist belegt</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung abgelehnt</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenseite getrennt</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Zeitüberschreitung beim Verbinden</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>Kein Weg zum Rechner</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>Netz nicht erreichbar</translation>
    </message>
    <message>
        <source>The picture {} could not be written: is the folder writable?</source>
        <translation>Das Bild {} ließ sich nicht schreiben: Ist der Ordner beschreibbar?</translation>
    </message>
    <message>
        <source>pose recorder: collect_s must be within 0 and 60</source>
        <translation>Aufnahme der Posen: collect_s muss zwischen 0 und 60 liegen</translation>
    </message>
    <message>
        <source>pose recorder: repeat_angle_rad must be between 0 and pi</source>
        <translation>Aufnahme der Posen: repeat_angle_rad muss zwischen 0 und pi liegen</translation>
    </message>
    <message>
        <source>stillness: {} must be between {} and {}, found {}</source>
        <translation>Stillhalten: {} muss zwischen {} und {} liegen, gefunden wurde {}</translation>
    </message>
    <message>
        <source>Cell {} is silent: nothing came from it for {}</source>
        <translation>Zelle {} ist stumm: Seit {} kam nichts von ihr</translation>
    </message>
    <message>
        <source>Cell {}</source>
        <translation>Zelle {}</translation>
    </message>
    <message>
        <source>exploration: cell {} of the wiring is there twice, or its ID is not one of a cell</source>
        <translation>Erkundung: Zelle {} der Verdrahtung ist doppelt vorhanden, oder ihre ID ist keine einer Zelle</translation>
    </message>
    <message>
        <source>exploration: a link of the wiring has an unknown port</source>
        <translation>Erkundung: Eine Verbindung der Verdrahtung hat einen unbekannten Port</translation>
    </message>
    <message>
        <source>exploration: there is no cell {}</source>
        <translation>Erkundung: Es gibt keine Zelle {}</translation>
    </message>
    <message>
        <source>exploration: {}: the model has no such port</source>
        <translation>Erkundung: {}: Das Modell hat keinen solchen Port</translation>
    </message>
    <message>
        <source>exploration: port {} of the wiring&apos;s cell {} is joined twice</source>
        <translation>Erkundung: Port {} der Zelle {} der Verdrahtung ist zweimal verbunden</translation>
    </message>
    <message>
        <source>exploration: {} must not be negative</source>
        <translation>Erkundung: {} darf nicht negativ sein</translation>
    </message>
    <message>
        <source>exploration: {} must be above 0, not less</source>
        <translation>Erkundung: {} muss über 0 liegen</translation>
    </message>
    <message>
        <source>exploration: hellos must be at least 1</source>
        <translation>Erkundung: hellos muss mindestens 1 sein</translation>
    </message>
    <message>
        <source>no port of the skin is free for a computer interface</source>
        <translation>kein Port der Haut ist für eine Rechnerschnittstelle frei</translation>
    </message>
    <message>
        <source>the surface is too small for these cells: where one is laid it is curved more sharply than the cell is wide</source>
        <translation>die Fläche ist für diese Zellen zu klein: Wo eine liegt, ist sie enger gekrümmt, als die Zelle breit ist</translation>
    </message>
    <message>
        <source>the surface is too small for this patch: cells {} and {} would lie on top of each other</source>
        <translation>die Fläche ist für dieses Hautstück zu klein: Die Zellen {} und {} lägen aufeinander</translation>
    </message>
    <message>
        <source>the surface does not close this ring: its two ends would be {} mm apart; leave the surface out for a cylinder that closes it</source>
        <translation>die Fläche schließt diesen Ring nicht: Seine beiden Enden lägen {} mm auseinander; ohne Angabe einer Fläche wird ein Zylinder genommen, der ihn schließt</translation>
    </message>
    <message>
        <source>patch {} needs a cell model with 1 pair of opposite ports that may be joined; {} has {}</source>
        <translation>Hautstück {} braucht ein Zellmodell mit 1 Paar gegenüberliegender Ports, die verbunden werden dürfen; {} hat {}</translation>
    </message>
    <message>
        <source>patch {} needs a cell model with {} pairs of opposite ports that may be joined; {} has {}</source>
        <translation>Hautstück {} braucht ein Zellmodell mit {} Paaren gegenüberliegender Ports, die verbunden werden dürfen; {} hat {}</translation>
    </message>
    <message>
        <source>patch &quot;{}&quot;: a ring has 3 to 100000 cells</source>
        <translation>Hautstück „{}“: Ein Ring hat 3 bis 100000 Zellen</translation>
    </message>
    <message>
        <source>patch &quot;{}&quot;: expected sheet:ROWSxCOLS</source>
        <translation>Hautstück „{}“: erwartet ist sheet:ZEILENxSPALTEN</translation>
    </message>
    <message>
        <source>patch &quot;{}&quot;: a sheet has 1 to 1000000 cells</source>
        <translation>Hautstück „{}“: Eine Matte hat 1 bis 1000000 Zellen</translation>
    </message>
    <message>
        <source>patch &quot;{}&quot; is not known; expected x17, ringN, ringN:closed or sheet:ROWSxCOLS</source>
        <translation>Hautstück „{}“ ist unbekannt; erwartet ist x17, ringN, ringN:closed oder sheet:ZEILENxSPALTEN</translation>
    </message>
    <message>
        <source>patch &quot;{}&quot;: a live skin, or one on a robot, has at most {} cells</source>
        <translation>Hautstück „{}“: Eine Haut in Betrieb oder auf einem Roboter hat höchstens {} Zellen</translation>
    </message>
    <message>
        <source>simulated skin: there is no cell {} to break; cells are 1 to {}</source>
        <translation>simulierte Haut: Es gibt keine Zelle {}, die defekt sein könnte; die Zellen sind 1 bis {}</translation>
    </message>
    <message>
        <source>simulated skin: {} has no link to break; the cell has links at no port</source>
        <translation>simulierte Haut: {} hat keine Verbindung, die defekt sein könnte; die Zelle hat an keinem Port Verbindungen</translation>
    </message>
    <message>
        <source>simulated skin: {} has no link to break; the cell has links at the ports {}</source>
        <translation>simulierte Haut: {} hat keine Verbindung, die defekt sein könnte; die Zelle hat Verbindungen an den Ports {}</translation>
    </message>
    <message>
        <source>simulated skin: the link at {} is broken already</source>
        <translation>simulierte Haut: Die Verbindung an {} ist schon defekt</translation>
    </message>
    <message>
        <source>simulated skin: the link at {} can&apos;t be reported at a wrong port: no other port of the cell is free for it</source>
        <translation>simulierte Haut: Die Verbindung an {} kann nicht an einem falschen Port gemeldet werden: Kein anderer Port der Zelle ist dafür frei</translation>
    </message>
    <message>
        <source>simulated skin: the link at {} can&apos;t be a joint or a cable: the rest of the closed ring holds both its sides together</source>
        <translation>simulierte Haut: Die Verbindung an {} kann kein Gelenk oder Kabel sein: Der Rest des geschlossenen Rings hält ihre beiden Seiten zusammen</translation>
    </message>
    <message>
        <source>simulated skin: {} must not be negative</source>
        <translation>simulierte Haut: {} darf nicht negativ sein</translation>
    </message>
    <message>
        <source>simulated skin: least_vibration_g must not be above most_vibration_g</source>
        <translation>simulierte Haut: least_vibration_g darf nicht über most_vibration_g liegen</translation>
    </message>
    <message>
        <source>simulated skin: joint_angle_rad must be finite</source>
        <translation>simulierte Haut: joint_angle_rad muss endlich sein</translation>
    </message>
    <message>
        <source>simulated skin: the direction that points up must be a finite vector other than zero</source>
        <translation>simulierte Haut: Die Richtung nach oben muss ein endlicher Vektor ungleich null sein</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: speed must be above 0</source>
        <translation>Quelle „{}“: speed muss über 0 liegen</translation>
    </message>
    <message>
        <source>the simulated robot turns by itself</source>
        <translation>der simulierte Roboter dreht sich von selbst</translation>
    </message>
    <message>
        <source>there is no cell {}</source>
        <translation>es gibt keine Zelle {}</translation>
    </message>
    <message>
        <source>another turn came before it was there</source>
        <translation>eine andere Drehung kam, bevor diese beendet war</translation>
    </message>
    <message>
        <source>a simulated skin has the rate of its cell model</source>
        <translation>eine simulierte Haut hat die Abtastrate ihres Zellmodells</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected sim:PATCH[?surface=...&amp;seed=N&amp;speed=X|max&amp;motion=hand|robot], found &quot;{}&quot;</source>
        <translation>Quelle „{}“: erwartet ist sim:PATCH[?surface=...&amp;seed=N&amp;speed=X|max&amp;motion=hand|robot], gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected stdin, without anything behind</source>
        <translation>Quelle „{}“: erwartet ist stdin ohne etwas dahinter</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected replay:FILE[?speed=X|max|step]</source>
        <translation>Quelle „{}“: erwartet ist replay:FILE[?speed=X|max|step]</translation>
    </message>
    <message>
        <source>the recording ended: {}</source>
        <translation>die Aufzeichnung ist beendet: {}</translation>
    </message>
    <message>
        <source>a recording can&apos;t be written there: {}</source>
        <translation>dort lässt sich keine Aufzeichnung schreiben: {}</translation>
    </message>
    <message>
        <source>is no recording of a skin, expected it to begin with &quot;SKINREC1&quot;</source>
        <translation>ist keine Aufzeichnung einer Haut, erwartet wurde ein Anfang mit „SKINREC1“</translation>
    </message>
    <message>
        <source>replay: speed: expected a number above 0</source>
        <translation>replay: speed: erwartet ist eine Zahl über 0</translation>
    </message>
    <message>
        <source>a recording takes no commands</source>
        <translation>eine Aufzeichnung nimmt keine Befehle an</translation>
    </message>
    <message>
        <source>playing; the device said: {}</source>
        <translation>wird abgespielt; das Gerät meldete: {}</translation>
    </message>
    <message>
        <source>a source can be started only once</source>
        <translation>eine Quelle kann nur einmal gestartet werden</translation>
    </message>
    <message>
        <source>exploring its cells</source>
        <translation>erkundet seine Zellen</translation>
    </message>
    <message>
        <source>its links or cells keep changing, {} times by now; they are taken over every {}</source>
        <translation>seine Verbindungen oder Zellen ändern sich ständig, bisher {}-mal; sie werden alle {} übernommen</translation>
    </message>
    <message>
        <source>samples in LSB need a cell model whose accelerometer.lsb_g is above 0</source>
        <translation>Messwerte in LSB brauchen ein Zellmodell, dessen accelerometer.lsb_g über 0 liegt</translation>
    </message>
    <message>
        <source>tcp://HOST:PORT, udp://HOST:PORT or serial:/dev/DEVICE</source>
        <translation>tcp://HOST:PORT, udp://HOST:PORT oder serial:/dev/DEVICE</translation>
    </message>
    <message>
        <source>a datagram of {} bytes, the limit is {}</source>
        <translation>ein Datagramm mit {} Bytes, die Grenze ist {}</translation>
    </message>
    <message>
        <source>no answer for {}</source>
        <translation>keine Antwort seit {}</translation>
    </message>
    <message>
        <source>nothing came for {}</source>
        <translation>seit {} kam nichts</translation>
    </message>
    <message>
        <source>the device is not connected</source>
        <translation>das Gerät ist nicht verbunden</translation>
    </message>
    <message>
        <source>too many commands wait for an answer</source>
        <translation>zu viele Befehle warten auf eine Antwort</translation>
    </message>
    <message>
        <source>the device can&apos;t light its cells</source>
        <translation>das Gerät kann seine Zellen nicht leuchten lassen</translation>
    </message>
    <message>
        <source>the device can&apos;t turn by itself</source>
        <translation>das Gerät kann sich nicht selbst drehen</translation>
    </message>
    <message>
        <source>surface &quot;{}&quot;: {}; expected plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M</source>
        <translation>Fläche „{}“: {}; erwartet ist plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD oder torus:R=M,r=M</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not name=value</source>
        <translation>„{}“ ist nicht Name=Wert</translation>
    </message>
    <message>
        <source>there is no &quot;{}&quot; here</source>
        <translation>„{}“ gibt es hier nicht</translation>
    </message>
    <message>
        <source>{} must be above 0</source>
        <translation>{} muss über 0 liegen</translation>
    </message>
    <message>
        <source>{} is given twice</source>
        <translation>{} ist zweimal angegeben</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>{} fehlt</translation>
    </message>
    <message>
        <source>surface &quot;{}&quot;: angle must be below pi/2 rad (it is between axis and surface)</source>
        <translation>Fläche „{}“: angle muss unter pi/2 rad liegen (es ist der Winkel zwischen Achse und Fläche)</translation>
    </message>
    <message>
        <source>surface &quot;{}&quot;: R must be larger than r, or the torus meets itself</source>
        <translation>Fläche „{}“: R muss größer als r sein, sonst durchdringt der Torus sich selbst</translation>
    </message>
    <message>
        <source>surface &quot;{}&quot; is not known; expected plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M</source>
        <translation>Fläche „{}“ ist unbekannt; erwartet ist plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD oder torus:R=M,r=M</translation>
    </message>
    <message>
        <source>at least {} points are needed, there are {}</source>
        <translation>mindestens {} Punkte sind nötig, vorhanden sind {}</translation>
    </message>
    <message>
        <source>the points must be finite</source>
        <translation>die Punkte müssen endlich sein</translation>
    </message>
    <message>
        <source>all points are the same</source>
        <translation>alle Punkte sind gleich</translation>
    </message>
    <message>
        <source>the points lie on a line</source>
        <translation>die Punkte liegen auf einer Linie</translation>
    </message>
    <message>
        <source>the points lie in a plane</source>
        <translation>die Punkte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>plane fit</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>sphere fit</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>cylinder fit</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>cone fit</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>cell model {} has no port {}</source>
        <translation>Zellmodell {} hat keinen Port {}</translation>
    </message>
    <message>
        <source>cell model {}</source>
        <translation>Zellmodell {}</translation>
    </message>
    <message>
        <source>{} must not be negative</source>
        <translation>{} darf nicht negativ sein</translation>
    </message>
    <message>
        <source>{} must be within {} m</source>
        <translation>{} muss innerhalb von {} m liegen</translation>
    </message>
    <message>
        <source>name must not be empty</source>
        <translation>name darf nicht leer sein</translation>
    </message>
    <message>
        <source>there must be at least one port</source>
        <translation>es muss mindestens einen Port geben</translation>
    </message>
    <message>
        <source>port {} is listed twice</source>
        <translation>Port {} ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>port {}: vector_m must point out of the cell&apos;s side, by at most {} m</source>
        <translation>Port {}: vector_m muss aus der Seite der Zelle zeigen, um höchstens {} m</translation>
    </message>
    <message>
        <source>forbidden_port_pairs names an unknown port</source>
        <translation>forbidden_port_pairs nennt einen unbekannten Port</translation>
    </message>
    <message>
        <source>interface_id must be above 0</source>
        <translation>interface_id muss über 0 liegen</translation>
    </message>
    <message>
        <source>side_angle_rad must be within {}</source>
        <translation>side_angle_rad darf höchstens {} betragen</translation>
    </message>
    <message>
        <source>two port numbers</source>
        <translation>zwei Portnummern</translation>
    </message>
    <message>
        <source>a cell model that makes sense ({})</source>
        <translation>ein sinnvolles Zellmodell ({})</translation>
    </message>
    <message>
        <source>there is no built-in cell model &quot;{}&quot;; there are:{}</source>
        <translation>es gibt kein eingebautes Zellmodell „{}“; vorhanden sind:{}</translation>
    </message>
    <message>
        <source>one of the solver&apos;s settings ({})</source>
        <translation>eine der Einstellungen des Lösers ({})</translation>
    </message>
    <message>
        <source>three numbers of at least 0</source>
        <translation>drei Zahlen von mindestens 0</translation>
    </message>
    <message>
        <source>settings that make sense ({})</source>
        <translation>sinnvolle Einstellungen ({})</translation>
    </message>
    <message>
        <source>&quot;global&quot;, &quot;tree&quot; or &quot;imported&quot;</source>
        <translation>„global“, „tree“ oder „imported“</translation>
    </message>
    <message>
        <source>a unit vector (to 1e-6)</source>
        <translation>ein Einheitsvektor (auf 1e-6 genau)</translation>
    </message>
    <message>
        <source>an upper triangle with variances of at least 0 on its diagonal</source>
        <translation>ein oberes Dreieck mit Varianzen von mindestens 0 auf der Diagonale</translation>
    </message>
    <message>
        <source>&quot;samples&quot; or &quot;links&quot;</source>
        <translation>„samples“ oder „links“</translation>
    </message>
    <message>
        <source>the same rotation as R_o_u</source>
        <translation>dieselbe Drehung wie R_o_u</translation>
    </message>
    <message>
        <source>a port of cell model {}</source>
        <translation>ein Port des Zellmodells {}</translation>
    </message>
    <message>
        <source>two cells, the smaller (ID, port) as source (target is {})</source>
        <translation>zwei Zellen, die mit kleinerem (ID, Port) als source (target ist {})</translation>
    </message>
    <message>
        <source>&quot;un&quot;, &quot;partially&quot;, &quot;fully&quot; or &quot;over&quot;</source>
        <translation>„un“, „partially“, „fully“ oder „over“</translation>
    </message>
    <message>
        <source>the code of a finding</source>
        <translation>der Code eines Befunds</translation>
    </message>
    <message>
        <source>one entry for each of the {} poses</source>
        <translation>ein Eintrag für jede der {} Posen</translation>
    </message>
    <message>
        <source>&quot;info&quot;, &quot;warning&quot; or &quot;error&quot;</source>
        <translation>„info“, „warning“ oder „error“</translation>
    </message>
    <message>
        <source>each patch once</source>
        <translation>jedes Hautstück einmal</translation>
    </message>
    <message>
        <source>each cell once</source>
        <translation>jede Zelle einmal</translation>
    </message>
    <message>
        <source>a cell of this patch</source>
        <translation>eine Zelle dieses Hautstücks</translation>
    </message>
    <message>
        <source>each link once</source>
        <translation>jede Verbindung einmal</translation>
    </message>
    <message>
        <source>a cell of this calibration</source>
        <translation>eine Zelle dieser Kalibrierung</translation>
    </message>
    <message>
        <source>at least one cell</source>
        <translation>mindestens eine Zelle</translation>
    </message>
    <message>
        <source>cells of this patch, from its origin to this cell</source>
        <translation>Zellen dieses Hautstücks, von seinem Ursprung bis zu dieser Zelle</translation>
    </message>
    <message>
        <source>expected letters, digits and _ - . /, found &quot;{}&quot;</source>
        <translation>erwartet sind Buchstaben, Ziffern und _ - . /, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>cell {}: {} is not a finite number, nothing written</source>
        <translation>Zelle {}: {} ist keine endliche Zahl, nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>row {}, {} is not a finite number, nothing written</source>
        <translation>Zeile {}, {} ist keine endliche Zahl, nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>cell {}: the single precision of a {} file can&apos;t hold how far away it is</source>
        <translation>Zelle {}: Sie liegt weiter entfernt, als eine Datei in {} mit ihrer einfachen Genauigkeit aufnehmen kann</translation>
    </message>
    <message>
        <source>its placement</source>
        <translation>ihre Lage</translation>
    </message>
    <message>
        <source>its covariance</source>
        <translation>ihre Kovarianz</translation>
    </message>
    <message>
        <source>its accelerometer&apos;s offset or scale</source>
        <translation>Offset oder Skalierung ihres Beschleunigungssensors</translation>
    </message>
    <message>
        <source>the placement of its sensor {}</source>
        <translation>die Lage ihres Sensors {}</translation>
    </message>
    <message>
        <source>its place in the layout</source>
        <translation>ihr Platz in der Zeichnung</translation>
    </message>
    <message>
        <source>export format &quot;{}&quot; is not known, expected one of {}</source>
        <translation>Exportformat „{}“ ist unbekannt, erwartet ist eines von {}</translation>
    </message>
    <message>
        <source>expected the name of a file or folder to export to</source>
        <translation>erwartet ist der Name einer Datei oder eines Ordners für den Export</translation>
    </message>
    <message>
        <source>{}, found &quot;{}&quot;</source>
        <translation>{}, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>{}, but there is none</source>
        <translation>{}, angegeben ist keines</translation>
    </message>
    <message>
        <source>the name of a built-in cell model, or a cell model as an object</source>
        <translation>der Name eines eingebauten Zellmodells oder ein Zellmodell als Objekt</translation>
    </message>
    <message>
        <source>a built-in cell model (there are:{}) or a cell model as an object</source>
        <translation>ein eingebautes Zellmodell (vorhanden sind:{}) oder ein Zellmodell als Objekt</translation>
    </message>
    <message>
        <source>variances (xx, yy, zz) of at least 0</source>
        <translation>Varianzen (xx, yy, zz) von mindestens 0</translation>
    </message>
    <message>
        <source>Placements of the TUM skin configuration {}</source>
        <translation>Lagen aus der TUM-Hautkonfiguration {}</translation>
    </message>
    <message>
        <source>Topology of the TUM skin configuration {}</source>
        <translation>Topologie aus der TUM-Hautkonfiguration {}</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>Zeile {}</translation>
    </message>
    <message>
        <source>this is not well-formed XML ({}; truncated?), expected a TUM SkinConfig</source>
        <translation>das ist kein wohlgeformtes XML ({}; abgeschnitten?), erwartet ist eine TUM-SkinConfig</translation>
    </message>
    <message>
        <source>expected the root element SkinConfig, found {}</source>
        <translation>erwartet ist das Wurzelelement SkinConfig, gefunden wurde {}</translation>
    </message>
    <message>
        <source>expected each cell once, found this ID again</source>
        <translation>erwartet ist jede Zelle einmal, diese ID kommt noch einmal vor</translation>
    </message>
    <message>
        <source>expected numberOfCells=&quot;{}&quot; cells, found {}</source>
        <translation>erwartet sind numberOfCells=&quot;{}&quot; Zellen, gefunden wurden {}</translation>
    </message>
    <message>
        <source>expected an element &lt;{}&gt;, but there is none</source>
        <translation>erwartet ist ein Element &lt;{}&gt;, vorhanden ist keines</translation>
    </message>
    <message>
        <source>expected only one &lt;{}&gt;</source>
        <translation>erwartet ist nur ein &lt;{}&gt;</translation>
    </message>
    <message>
        <source>expected an attribute {}, but there is none</source>
        <translation>erwartet ist ein Attribut {}, vorhanden ist keines</translation>
    </message>
    <message>
        <source>expected metres from the root cell, at most {}</source>
        <translation>erwartet sind Meter von der Wurzelzelle, höchstens {}</translation>
    </message>
    <message>
        <source>expected a rotation matrix (orthogonal to 1e-6, determinant +1)</source>
        <translation>erwartet ist eine Drehmatrix (auf 1e-6 orthogonal, Determinante +1)</translation>
    </message>
    <message>
        <source>expected id=&quot;{}&quot;, found {}</source>
        <translation>erwartet ist id=&quot;{}&quot;, gefunden wurde {}</translation>
    </message>
    <message>
        <source>expected each port once, found it again</source>
        <translation>erwartet ist jeder Port einmal, dieser kommt noch einmal vor</translation>
    </message>
    <message>
        <source>expected size=&quot;{}&quot; neighbors, found {}</source>
        <translation>erwartet sind size=&quot;{}&quot; Nachbarn, gefunden wurden {}</translation>
    </message>
    <message>
        <source>expected a matrix of {} x {}, found {} x {}</source>
        <translation>erwartet ist eine Matrix von {} x {}, gefunden wurde {} x {}</translation>
    </message>
    <message>
        <source>lies outside the matrix of {} x {}</source>
        <translation>liegt außerhalb der Matrix von {} x {}</translation>
    </message>
    <message>
        <source>expected each element once, found it again</source>
        <translation>erwartet ist jedes Element einmal, dieses kommt noch einmal vor</translation>
    </message>
    <message>
        <source>expected {} elements, but some are missing</source>
        <translation>erwartet sind {} Elemente, aber einige fehlen</translation>
    </message>
    <message>
        <source>{} g</source>
        <translation>{} g</translation>
    </message>
    <message>
        <source>{} to {} g</source>
        <translation>{} bis {} g</translation>
    </message>
    <message>
        <source>Cell {} reads {}: gravity is 1 g, give or take {} g</source>
        <translation>Zelle {} misst {}: Die Schwerkraft ist 1 g, plus oder minus {} g</translation>
    </message>
    <message>
        <source>{} cells read {}: gravity is 1 g, give or take {} g</source>
        <translation>{} Zellen messen {}: Die Schwerkraft ist 1 g, plus oder minus {} g</translation>
    </message>
    <message>
        <source>The cell sends and reads {}</source>
        <translation>Die Zelle sendet und misst {}</translation>
    </message>
    <message>
        <source>All {} cells send and read {}</source>
        <translation>Alle {} Zellen senden und messen {}</translation>
    </message>
    <message>
        <source>surface: expected plane, sphere, cylinder or cone, found &quot;{}&quot;</source>
        <translation>Fläche: erwartet ist plane, sphere, cylinder oder cone, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>a {} has no one radius to compare with</source>
        <translation>zur Form {} gehört kein einzelner Radius zum Vergleichen</translation>
    </message>
    <message>
        <source>loop: there is no cell {}</source>
        <translation>Schleife: Es gibt keine Zelle {}</translation>
    </message>
    <message>
        <source>loop: cell model {} has no port {}</source>
        <translation>Schleife: Zellmodell {} hat keinen Port {}</translation>
    </message>
    <message>
        <source>loop: {} is joined to a neighbour, expected a free port</source>
        <translation>Schleife: {} ist mit einem Nachbarn verbunden, erwartet ist ein freier Port</translation>
    </message>
    <message>
        <source>loop: cells {} and {} lie in different patches</source>
        <translation>Schleife: Die Zellen {} und {} liegen in verschiedenen Hautstücken</translation>
    </message>
    <message>
        <source>loop: expected two different ports</source>
        <translation>Schleife: erwartet sind zwei verschiedene Ports</translation>
    </message>
    <message>
        <source>there is no cell {} to be left out</source>
        <translation>es gibt keine Zelle {}, die ausgelassen werden könnte</translation>
    </message>
    <message>
        <source>hold-out: there is no pose {}</source>
        <translation>zurückgehaltene Pose: Es gibt keine Pose {}</translation>
    </message>
    <message>
        <source>a pose must hold a capture</source>
        <translation>eine Pose muss eine Aufnahme enthalten</translation>
    </message>
    <message>
        <source>there is no pose at place {}</source>
        <translation>an Platz {} ist keine Pose</translation>
    </message>
    <message>
        <source>entry {} is no pose of the session</source>
        <translation>Eintrag {} ist keine Pose der Sitzung</translation>
    </message>
    <message>
        <source>a pose can be restored that was removed</source>
        <translation>wiederhergestellt werden kann nur eine Pose, die entfernt wurde</translation>
    </message>
    <message>
        <source>expected samples in captures and nowhere else</source>
        <translation>erwartet sind Messwerte in Aufnahmen und nirgends sonst</translation>
    </message>
    <message>
        <source>expected the skin first, found &quot;{}&quot;</source>
        <translation>erwartet ist zuerst die Haut, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a skin must have a cell model</source>
        <translation>eine Haut muss ein Zellmodell haben</translation>
    </message>
    <message>
        <source>a session needs a skin first</source>
        <translation>eine Sitzung braucht zuerst eine Haut</translation>
    </message>
    <message>
        <source>the data end in the middle</source>
        <translation>die Daten enden mittendrin</translation>
    </message>
    <message>
        <source>expected finite numbers</source>
        <translation>erwartet sind endliche Zahlen</translation>
    </message>
    <message>
        <source>raw samples: expected cells</source>
        <translation>Rohmesswerte: erwartet sind Zellen</translation>
    </message>
    <message>
        <source>expected readings of at most 32767 steps</source>
        <translation>erwartet sind Messwerte von höchstens 32767 Stufen</translation>
    </message>
    <message>
        <source>the mean must be finite and at most 1e6 g</source>
        <translation>der Mittelwert muss endlich und höchstens 1e6 g sein</translation>
    </message>
    <message>
        <source>the covariance must be finite and at most 1e13 g^2</source>
        <translation>die Kovarianz muss endlich und höchstens 1e13 g^2 sein</translation>
    </message>
    <message>
        <source>variances must be at least 0</source>
        <translation>Varianzen müssen mindestens 0 sein</translation>
    </message>
    <message>
        <source>the temperature must be finite</source>
        <translation>die Temperatur muss endlich sein</translation>
    </message>
    <message>
        <source>raw samples: too many for one pose</source>
        <translation>Rohmesswerte: zu viele für eine Pose</translation>
    </message>
    <message>
        <source>cell {}: {} to be stored</source>
        <translation>Zelle {} lässt sich nicht speichern: {}</translation>
    </message>
    <message>
        <source>samples: expected {} bytes for each cell, found {} bytes</source>
        <translation>Messwerte: erwartet sind {} Bytes für jede Zelle, gefunden wurden {} Bytes</translation>
    </message>
    <message>
        <source>samples: cell {}: expected no other flags than 1 (has a temperature)</source>
        <translation>Messwerte: Zelle {}: erwartet ist kein anderes Kennzeichen als 1 (hat eine Temperatur)</translation>
    </message>
    <message>
        <source>samples: cell {}: {}</source>
        <translation>Messwerte: Zelle {}: {}</translation>
    </message>
    <message>
        <source>raw samples: must be finite to be stored</source>
        <translation>Rohmesswerte: müssen endlich sein, um gespeichert zu werden</translation>
    </message>
    <message>
        <source>raw samples: times must be finite to be stored</source>
        <translation>Rohmesswerte: Zeiten müssen endlich sein, um gespeichert zu werden</translation>
    </message>
    <message>
        <source>raw samples: expected numbers of 2, 4 or 8 bytes</source>
        <translation>Rohmesswerte: erwartet sind Zahlen mit 2, 4 oder 8 Bytes</translation>
    </message>
    <message>
        <source>raw samples: expected the end, found more data</source>
        <translation>Rohmesswerte: erwartet ist das Ende, gefunden wurden weitere Daten</translation>
    </message>
    <message>
        <source>there is no place {} among the poses</source>
        <translation>unter den Posen gibt es keinen Platz {}</translation>
    </message>
    <message>
        <source>a link joins two ports, and both ends are port {} of cell {}</source>
        <translation>eine Verbindung verbindet zwei Ports, und beide Enden sind Port {} der Zelle {}</translation>
    </message>
    <message>
        <source>another port than the source&apos;s: a link has two ends</source>
        <translation>ein anderer Port als der von source: Eine Verbindung hat zwei Enden</translation>
    </message>
    <message>
        <source>the disk has only {} MiB left; for raw samples {} MiB have to be free</source>
        <translation>auf der Platte sind nur noch {} MiB frei; für Rohmesswerte müssen {} MiB frei sein</translation>
    </message>
    <message>
        <source>the session was closed before this could be written to its file</source>
        <translation>die Sitzung wurde geschlossen, bevor dies in ihre Datei geschrieben werden konnte</translation>
    </message>
    <message>
        <source>the file is damaged: expected digests of 32 bytes</source>
        <translation>die Datei ist beschädigt: erwartet sind Prüfsummen mit 32 Bytes</translation>
    </message>
    <message>
        <source>the journal is empty, expected a skin as its first entry</source>
        <translation>das Journal ist leer, erwartet ist eine Haut als erster Eintrag</translation>
    </message>
    <message>
        <source>cannot be moved to {}: {}</source>
        <translation>lässt sich nicht nach {} verschieben: {}</translation>
    </message>
    <message>
        <source>is open in another window, close it there first</source>
        <translation>ist in einem anderen Fenster offen und muss dort zuerst geschlossen werden</translation>
    </message>
    <message>
        <source>something of that name is there</source>
        <translation>dort gibt es schon etwas mit diesem Namen</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>stehend</translation>
    </message>
    <message>
        <source>on its side</source>
        <translation>auf der Seite</translation>
    </message>
    <message>
        <source>pose {}</source>
        <translation>Pose {}</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>erwartet ist eine Zahl</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>erwartet ist ein Text</translation>
    </message>
    <message>
        <source>the file is damaged: column {}: expected {}</source>
        <translation>die Datei ist beschädigt: Spalte {}: erwartet ist {}</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>binary data</source>
        <translation>Binärdaten</translation>
    </message>
    <message>
        <source>the file ends in the middle (truncated?): expected {} bytes, found {}</source>
        <translation>die Datei endet mittendrin (abgeschnitten?): erwartet sind {} Bytes, gefunden wurden {}</translation>
    </message>
    <message>
        <source>is already open for writing in this Hexoderm: close it there first</source>
        <translation>ist in diesem Hexoderm schon zum Schreiben offen und muss dort zuerst geschlossen werden</translation>
    </message>
    <message>
        <source>the file is damaged, expected a whole database: {}</source>
        <translation>die Datei ist beschädigt, erwartet ist eine ganze Datenbank: {}</translation>
    </message>
    <message>
        <source>is an SQLite database, but not a Hexoderm session (*.hexo): expected application_id {}</source>
        <translation>ist eine SQLite-Datenbank, aber keine Hexoderm-Sitzung (*.hexo): erwartet ist application_id {}</translation>
    </message>
    <message>
        <source>user_version: this file has version {}, this program reads up to version {}</source>
        <translation>user_version: Diese Datei hat Version {}, dieses Programm liest bis Version {}</translation>
    </message>
    <message>
        <source>the file is damaged or changed: expected the tables of a Hexoderm session of version {} and nothing else</source>
        <translation>die Datei ist beschädigt oder verändert: erwartet sind die Tabellen einer Hexoderm-Sitzung der Version {} und nichts sonst</translation>
    </message>
    <message>
        <source>an array of {}</source>
        <translation>ein Array mit {}</translation>
    </message>
    <message>
        <source>top level</source>
        <translation>oberste Ebene</translation>
    </message>
    <message>
        <source>line {}, column {}</source>
        <translation>Zeile {}, Spalte {}</translation>
    </message>
    <message>
        <source>line {}, column {}, at {}</source>
        <translation>Zeile {}, Spalte {}, bei {}</translation>
    </message>
    <message>
        <source>a value that is not a finite number can&apos;t be written to a file</source>
        <translation>ein Wert, der keine endliche Zahl ist, lässt sich nicht in eine Datei schreiben</translation>
    </message>
    <message>
        <source>expected {}, found {}</source>
        <translation>erwartet ist {}, gefunden wurde {}</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>ein Array</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a number from {} to {}</source>
        <translation>eine Zahl von {} bis {}</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>a number of at least 0</source>
        <translation>eine Zahl von mindestens 0</translation>
    </message>
    <message>
        <source>a whole number from {} to {}</source>
        <translation>eine ganze Zahl von {} bis {}</translation>
    </message>
    <message>
        <source>a whole number of 64 bits</source>
        <translation>eine ganze Zahl mit 64 Bit</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>an array of {} numbers</source>
        <translation>ein Array mit {} Zahlen</translation>
    </message>
    <message>
        <source>a rotation matrix (row-major, orthogonal to 1e-6, determinant +1)</source>
        <translation>eine Drehmatrix (zeilenweise, auf 1e-6 orthogonal, Determinante +1)</translation>
    </message>
    <message>
        <source>expected &quot;{}&quot;, found {}</source>
        <translation>erwartet ist „{}“, gefunden wurde {}</translation>
    </message>
    <message>
        <source>expected &quot;{}&quot;, but there is none</source>
        <translation>erwartet ist „{}“, angegeben ist keines</translation>
    </message>
    <message>
        <source>this file has version {}, this program reads up to version {}</source>
        <translation>diese Datei hat Version {}, dieses Programm liest bis Version {}</translation>
    </message>
    <message>
        <source>cell {}, port {}</source>
        <translation>Zelle {}, Port {}</translation>
    </message>
    <message>
        <source>&quot;deg&quot;, &quot;mm&quot;, &quot;mg&quot; or &quot;s&quot;</source>
        <translation>„deg“, „mm“, „mg“ oder „s“</translation>
    </message>
    <message>
        <source>messages within messages to a depth of {}</source>
        <translation>ineinander geschachtelte Meldungen bis zur Tiefe {}</translation>
    </message>
    <message>
        <source>a text with a {{}} for each of the {} arguments</source>
        <translation>ein Text mit einem {{}} für jedes der {} Argumente</translation>
    </message>
    <message>
        <source>SHA-256 is not available in this OpenSSL</source>
        <translation>SHA-256 ist in diesem OpenSSL nicht verfügbar</translation>
    </message>
    <message>
        <source>expected {}, found &quot;{}&quot;</source>
        <translation>erwartet ist {}, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>expected a finite number</source>
        <translation>erwartet ist eine endliche Zahl</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot be put away for a while: {}</source>
        <translation>lässt sich nicht vorübergehend beiseitelegen: {}</translation>
    </message>
    <message>
        <source>expected a name that ends in .pdf or .html</source>
        <translation>erwartet wird ein Name, der auf .pdf oder .html endet</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>Connecting to {}</source>
        <translation>Verbindung mit {}</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <comment>the end of a list</comment>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>{} must be from {} to {}, found {}</source>
        <translation>{} muss zwischen {} und {} liegen, gefunden: {}</translation>
    </message>
    <message>
        <source>a covariance (positive semidefinite)</source>
        <translation>eine Kovarianz (positiv semidefinit)</translation>
    </message>
    <message>
        <source>is not a file, and is not replaced by one</source>
        <translation>ist keine Datei und wird nicht durch eine ersetzt</translation>
    </message>
    <message>
        <source>csv is a folder of several files and can&apos;t be written as one: give a folder</source>
        <translation>csv ist ein Ordner mit mehreren Dateien und lässt sich nicht als eine schreiben: einen Ordner angeben</translation>
    </message>
    <message>
        <source>is too large: at most {} MB of XML are read</source>
        <translation>ist zu groß: Von XML werden höchstens {} MB gelesen</translation>
    </message>
    <message>
        <source>the covariance must be positive semidefinite</source>
        <translation>die Kovarianz muss positiv semidefinit sein</translation>
    </message>
    <message>
        <source>is a link to {}, where there is nothing: make that file or remove the link first</source>
        <translation>ist eine Verknüpfung auf {}, wo nichts ist: zuerst diese Datei anlegen oder die Verknüpfung entfernen</translation>
    </message>
    <message>
        <source>is too large or does not end: at most {} MB are read</source>
        <translation>ist zu groß oder endet nicht: Höchstens {} MB werden gelesen</translation>
    </message>
    <message>
        <source>is a disk or a socket, nothing is written to it</source>
        <translation>ist ein Datenträger oder ein Socket, es wird nichts darauf geschrieben</translation>
    </message>
    <message>
        <source>is there twice, expected each key once</source>
        <translation>steht zweimal da, jeder Schlüssel darf nur einmal vorkommen</translation>
    </message>
    <message>
        <source>the file has too many values, at most {} are read</source>
        <translation>die Datei hat zu viele Werte, höchstens {} werden gelesen</translation>
    </message>
    <message>
        <source>is nested too deeply, at most {} levels are read</source>
        <translation>ist zu tief verschachtelt, höchstens {} Ebenen werden gelesen</translation>
    </message>
    <message>
        <source>The device has not described itself: {}</source>
        <translation>Das Gerät hat sich nicht beschrieben: {}</translation>
    </message>
    <message>
        <source>The device has not described itself.</source>
        <translation>Das Gerät hat sich nicht beschrieben.</translation>
    </message>
    <message>
        <source>No readings came: {}</source>
        <translation>Es kamen keine Messwerte: {}</translation>
    </message>
    <message>
        <source>No readings came.</source>
        <translation>Es kamen keine Messwerte.</translation>
    </message>
    <message>
        <source>There is no link that both of its cells report; a calibration needs joined cells.</source>
        <translation>Keine Verbindung wird von beiden Zellen gemeldet; eine Kalibrierung braucht verbundene Zellen.</translation>
    </message>
    <message>
        <source>No two joined cells send readings.</source>
        <translation>Keine zwei verbundenen Zellen senden Messwerte.</translation>
    </message>
    <message>
        <source>No cell sent two readings; a pose needs at least 10 of each cell.</source>
        <translation>Keine Zelle hat zwei Messwerte gesendet; eine Pose braucht mindestens 10 von jeder Zelle.</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>Nanosekunden</translation>
    </message>
    <message>
        <source>the norm of the readings is {} in the median: are these m/s2? Expected g, and 1 g at rest (1 g is 9.80665 m/s2)</source>
        <translation>der Betrag der Messwerte ist im Median {}: Sind das m/s2? Erwartet wird g, in Ruhe also 1 g (1 g sind 9,80665 m/s2)</translation>
    </message>
    <message>
        <source>the norm of the readings is {} in the median: are these mg? Expected g, and 1 g at rest</source>
        <translation>der Betrag der Messwerte ist im Median {}: Sind das mg? Erwartet wird g, in Ruhe also 1 g</translation>
    </message>
    <message>
        <source>the norm of the readings is {} in the median: are these LSB, of which the cell model has {} in 1 g? Expected g, and 1 g at rest</source>
        <translation>der Betrag der Messwerte ist im Median {}: Sind das LSB, von denen im Zellmodell {} auf 1 g kommen? Erwartet wird g, in Ruhe also 1 g</translation>
    </message>
    <message>
        <source>the norm of the readings is {} g in the median, expected 1 g at rest</source>
        <translation>der Betrag der Messwerte ist im Median {} g, erwartet wird in Ruhe 1 g</translation>
    </message>
    <message>
        <source>a cell&apos;s samples are {} us apart, but hello.rate_hz says {} Hz: are these {}? Expected microseconds</source>
        <translation>die Messwerte einer Zelle liegen {} µs auseinander, hello.rate_hz sagt aber {} Hz: Sind das {}? Erwartet werden Mikrosekunden</translation>
    </message>
    <message>
        <source>a cell&apos;s samples are {} us apart, but the cell model&apos;s accelerometer has {} Hz: are these milliseconds? Expected microseconds</source>
        <translation>die Messwerte einer Zelle liegen {} µs auseinander, der Beschleunigungssensor des Zellmodells hat aber {} Hz: Sind das Millisekunden? Erwartet werden Mikrosekunden</translation>
    </message>
    <message>
        <source>in {} of this computer the times went on by {} us: are these {}? Expected microseconds</source>
        <translation>während {} dieses Rechners liefen die Zeiten um {} µs weiter: Sind das {}? Erwartet werden Mikrosekunden</translation>
    </message>
    <message>
        <source>IDs of cells begin with 1</source>
        <translation>die IDs der Zellen beginnen mit 1</translation>
    </message>
    <message>
        <source>the model&apos;s ports are {}</source>
        <translation>die Ports des Modells sind {}</translation>
    </message>
    <message>
        <source>both cells of a link have to list it</source>
        <translation>beide Zellen müssen eine Verbindung aufführen</translation>
    </message>
    <message>
        <source>{} Expected: {}</source>
        <translation>{} Erwartet: {}</translation>
    </message>
    <message>
        <source>expected at least one cell</source>
        <translation>erwartet wird mindestens eine Zelle</translation>
    </message>
    <message>
        <source>{}; the message begins: {}</source>
        <translation>{}; die Nachricht beginnt: {}</translation>
    </message>
    <message>
        <source>the device speaks SkinWire {}, this program SkinWire {}</source>
        <translation>das Gerät spricht SkinWire {}, dieses Programm SkinWire {}</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>eine Zahl ist außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>the payload is not the protobuf message {} that its type says</source>
        <translation>der Inhalt ist nicht die Protobuf-Nachricht {}, die sein Typ nennt</translation>
    </message>
    <message>
        <source>{} has no field with the number {}</source>
        <translation>{} hat kein Feld mit der Nummer {}</translation>
    </message>
    <message>
        <source>a message can&apos;t be sent: {}</source>
        <translation>eine Nachricht lässt sich nicht senden: {}</translation>
    </message>
    <message>
        <source>this looks like a line of JSON; lines go over TCP and standard input, here bodies of bytes with a CRC are expected</source>
        <translation>das sieht nach einer Zeile JSON aus; Zeilen gehen über TCP und die Standardeingabe, hier werden Bytes mit einer CRC erwartet</translation>
    </message>
    <message>
        <source>a length stands before the body; here the body is expected alone</source>
        <translation>vor der Nachricht steht eine Länge; hier wird die Nachricht allein erwartet</translation>
    </message>
    <message>
        <source>the CRC is big-endian, expected little-endian</source>
        <translation>die CRC ist Big-Endian, erwartet wird Little-Endian</translation>
    </message>
    <message>
        <source>the CRC is CRC-32, expected CRC-32C (polynomial 0x1EDC6F41)</source>
        <translation>die CRC ist CRC-32, erwartet wird CRC-32C (Polynom 0x1EDC6F41)</translation>
    </message>
    <message>
        <source>the CRC is wrong</source>
        <translation>die CRC ist falsch</translation>
    </message>
    <message>
        <source>expected 6 to {} bytes, found {}</source>
        <translation>erwartet werden 6 bis {} Bytes, gefunden {}</translation>
    </message>
    <message>
        <source>expected a line of at most {} bytes</source>
        <translation>erwartet wird eine Zeile von höchstens {} Bytes</translation>
    </message>
    <message>
        <source>this is no message: {}</source>
        <translation>das ist keine Nachricht: {}</translation>
    </message>
    <message>
        <source>the length of a frame is big-endian, expected little-endian</source>
        <translation>die Länge eines Rahmens ist Big-Endian, erwartet wird Little-Endian</translation>
    </message>
    <message>
        <source>this is neither a line of JSON nor a frame that begins with its length</source>
        <translation>das ist weder eine Zeile JSON noch ein Rahmen, der mit seiner Länge beginnt</translation>
    </message>
    <message>
        <source>this is text in UTF-16, expected lines of JSON in UTF-8</source>
        <translation>das ist Text in UTF-16, erwartet werden Zeilen JSON in UTF-8</translation>
    </message>
    <message>
        <source>a frame says that it is {} bytes long, the limit is {}</source>
        <translation>ein Rahmen nennt eine Länge von {} Bytes, die Grenze ist {}</translation>
    </message>
    <message>
        <source>the bytes before a 0x00 are not COBS</source>
        <translation>die Bytes vor einer 0x00 sind kein COBS</translation>
    </message>
    <message>
        <source>this looks like lines of JSON; on a serial port frames of bytes in COBS, each before a 0x00, are expected</source>
        <translation>das sieht nach Zeilen JSON aus; an einer seriellen Schnittstelle werden Rahmen in COBS erwartet, jeder vor einer 0x00</translation>
    </message>
    <message>
        <source>expected a line feed (0x0A) after every message</source>
        <translation>erwartet wird ein Zeilenvorschub (0x0A) nach jeder Nachricht</translation>
    </message>
    <message>
        <source>more than {} bytes without an end</source>
        <translation>mehr als {} Bytes ohne ein Ende</translation>
    </message>
    <message>
        <source>expected an object with one member, which names the message ({}), found {}</source>
        <translation>erwartet wird ein Objekt mit einem Eintrag, der die Nachricht nennt ({}), gefunden {}</translation>
    </message>
    <message>
        <source>expected one message in a line, found {}</source>
        <translation>erwartet wird eine Nachricht je Zeile, gefunden {}</translation>
    </message>
    <message>
        <source>expected a member that names the message ({}), found none</source>
        <translation>erwartet wird ein Eintrag, der die Nachricht nennt ({}), gefunden keiner</translation>
    </message>
    <message>
        <source>there is no message &quot;{}&quot;; did you mean &quot;{}&quot;?</source>
        <translation>es gibt keine Nachricht „{}“; ist „{}“ gemeint?</translation>
    </message>
    <message>
        <source>there is no message &quot;{}&quot;; expected one of {}</source>
        <translation>es gibt keine Nachricht „{}“; erwartet wird eine von {}</translation>
    </message>
    <message>
        <source>expected an object, found {}</source>
        <translation>erwartet wird ein Objekt, gefunden {}</translation>
    </message>
    <message>
        <source>there is no such field; did you mean {}?</source>
        <translation>dieses Feld gibt es nicht; ist {} gemeint?</translation>
    </message>
    <message>
        <source>there is no such field; there are {}</source>
        <translation>dieses Feld gibt es nicht; es gibt {}</translation>
    </message>
    <message>
        <source>expected an array, found {}</source>
        <translation>erwartet wird ein Array, gefunden {}</translation>
    </message>
    <message>
        <source>expected true or false, found {}</source>
        <translation>erwartet wird true oder false, gefunden {}</translation>
    </message>
    <message>
        <source>expected a text, found an object; a cell model goes as the text of its JSON</source>
        <translation>erwartet wird ein Text, gefunden ein Objekt; ein Zellmodell wird als Text seines JSON gesendet</translation>
    </message>
    <message>
        <source>expected a text, found {}</source>
        <translation>erwartet wird ein Text, gefunden {}</translation>
    </message>
    <message>
        <source>expected a whole number from {} to {}, found {}</source>
        <translation>erwartet wird eine ganze Zahl von {} bis {}, gefunden {}</translation>
    </message>
    <message>
        <source>expected a number, found {}</source>
        <translation>erwartet wird eine Zahl, gefunden {}</translation>
    </message>
    <message>
        <source>character {}: expected finite numbers, found {}; leave out a cell that has no reading</source>
        <translation>Zeichen {}: erwartet werden endliche Zahlen, gefunden {}; eine Zelle ohne Messwert weglassen</translation>
    </message>
    <message>
        <source>the line ends in the middle of its JSON; expected a whole message in one line</source>
        <translation>die Zeile endet mitten in ihrem JSON; erwartet wird eine ganze Nachricht in einer Zeile</translation>
    </message>
    <message>
        <source>character {} is not JSON any more; expected a line like {}</source>
        <translation>ab Zeichen {} ist das kein JSON; erwartet wird eine Zeile wie {}</translation>
    </message>
    <message>
        <source>expected finite numbers, found one that is too large</source>
        <translation>erwartet werden endliche Zahlen, gefunden eine zu große</translation>
    </message>
    <message>
        <source>expected {} numbers, found {}</source>
        <translation>erwartet werden {} Zahlen, gefunden {}</translation>
    </message>
    <message>
        <source>expected at most {} bytes, found {}</source>
        <translation>erwartet werden höchstens {} Bytes, gefunden {}</translation>
    </message>
    <message>
        <source>expected a built-in model&apos;s name or a model as JSON text, found nothing</source>
        <translation>erwartet wird der Name eines eingebauten Modells oder ein Modell als JSON-Text, gefunden nichts</translation>
    </message>
    <message>
        <source>expected 0 to {}</source>
        <translation>erwartet wird 0 bis {}</translation>
    </message>
    <message>
        <source>expected 1 to {}</source>
        <translation>erwartet wird 1 bis {}</translation>
    </message>
    <message>
        <source>expected less than parts ({}), found {}</source>
        <translation>erwartet wird weniger als parts ({}), gefunden {}</translation>
    </message>
    <message>
        <source>expected at most {} cells</source>
        <translation>erwartet werden höchstens {} Zellen</translation>
    </message>
    <message>
        <source>expected numbers of at least 0</source>
        <translation>erwartet werden Zahlen von mindestens 0</translation>
    </message>
    <message>
        <source>expected at least 1</source>
        <translation>erwartet wird mindestens 1</translation>
    </message>
    <message>
        <source>expected the IDs of the cells that the readings are of, found none</source>
        <translation>erwartet werden die IDs der Zellen, von denen die Messwerte sind, gefunden keine</translation>
    </message>
    <message>
        <source>expected exactly one of raw_lsb, acceleration_g and mean_g with cells, found {}</source>
        <translation>mit cells wird genau eines von raw_lsb, acceleration_g und mean_g erwartet, gefunden {}</translation>
    </message>
    <message>
        <source>variance_g2 and count belong to mean_g, which is not there</source>
        <translation>variance_g2 und count gehören zu mean_g, das fehlt</translation>
    </message>
    <message>
        <source>expected a multiple of 3 numbers for each of {} cells, found {}</source>
        <translation>erwartet wird ein Vielfaches von 3 Zahlen für jede von {} Zellen, gefunden {}</translation>
    </message>
    <message>
        <source>expected at least 1 between several ticks ({} here)</source>
        <translation>zwischen mehreren Takten (hier {}) wird mindestens 1 erwartet</translation>
    </message>
    <message>
        <source>expected at most 2^53</source>
        <translation>erwartet wird höchstens 2^53</translation>
    </message>
    <message>
        <source>expected above 0, up to {}</source>
        <translation>erwartet wird über 0, bis {}</translation>
    </message>
    <message>
        <source>expected a unit vector</source>
        <translation>erwartet wird ein Einheitsvektor</translation>
    </message>
    <message>
        <source>expected done or working, found both</source>
        <translation>erwartet wird done oder working, gefunden beides</translation>
    </message>
    <message>
        <source>a cell is twice in one message</source>
        <translation>eine Zelle steht zweimal in einer Nachricht</translation>
    </message>
    <message>
        <source>the device sends other values of cell model {} than before</source>
        <translation>das Gerät sendet andere Werte des Zellmodells {} als zuvor</translation>
    </message>
    <message>
        <source>the device changed its cell model from {} to {}</source>
        <translation>das Gerät hat sein Zellmodell von {} zu {} gewechselt</translation>
    </message>
    <message>
        <source>the topology has no cell {}; expected one of its {} cells</source>
        <translation>die Topologie hat keine Zelle {}; erwartet wird eine ihrer {} Zellen</translation>
    </message>
    <message>
        <source>is missing, or 0 again; expected the device&apos;s clock in microseconds</source>
        <translation>fehlt oder ist wieder 0; erwartet wird die Uhr des Geräts in Mikrosekunden</translation>
    </message>
    <message>
        <source>went back from {} to {}; expected microseconds that never go back</source>
        <translation>ging von {} auf {} zurück; erwartet werden Mikrosekunden, die nie zurückgehen</translation>
    </message>
    <message>
        <source>is {} again, at which a cell of the message already was; expected microseconds (milliseconds stand still between samples)</source>
        <translation>ist wieder {}, wozu eine Zelle der Nachricht schon einen Messwert hatte; erwartet werden Mikrosekunden (Millisekunden stehen zwischen Messwerten still)</translation>
    </message>
    <message>
        <source>expected {}, found {}; it counts the samples sent before (one cell at one tick), not messages</source>
        <translation>erwartet wird {}, gefunden {}; gezählt werden die vorher gesendeten Messwerte (eine Zelle zu einem Takt), nicht Nachrichten</translation>
    </message>
    <message>
        <source>no whole topology came; expected topology after hello, and all its parts</source>
        <translation>es kam keine vollständige Topologie; erwartet wird topology nach hello, mit allen Teilen</translation>
    </message>
    <message>
        <source>no hello came that can be used; expected hello before everything else</source>
        <translation>es kam kein brauchbares hello; erwartet wird hello vor allem anderen</translation>
    </message>
    <message>
        <source>there is no such key; did you mean {}?</source>
        <translation>diesen Schlüssel gibt es nicht; ist {} gemeint?</translation>
    </message>
    <message>
        <source>there is no such key; there are {}</source>
        <translation>diesen Schlüssel gibt es nicht; es gibt {}</translation>
    </message>
    <message>
        <source>Of {} cells only {} have readings that can be used: the shape shown follows mostly from the ports.</source>
        <translation>Von {} Zellen haben nur {} brauchbare Messwerte: Die gezeigte Form folgt größtenteils aus den Ports.</translation>
    </message>
    <message>
        <source>Look at the findings and check the readings of the cells.</source>
        <translation>Befunde ansehen und die Messwerte der Zellen prüfen.</translation>
    </message>
    <message>
        <source>All {} cells read the same, digit for digit, {}: the readings of one are delivered for all. None is used.</source>
        <translation>Alle {} Zellen messen {} Stelle für Stelle dasselbe: Die Messwerte einer Zelle werden für alle geliefert. Keiner wird benutzt.</translation>
    </message>
    <message>
        <source>The cells {} read the same, digit for digit, {}: no two sensors do, so one&apos;s readings are delivered for the others too. None of them is used; they are placed through their links.</source>
        <translation>Die Zellen {} messen {} Stelle für Stelle dasselbe: Das tun keine zwei Sensoren, also werden die Messwerte der einen auch für die anderen geliefert. Keine davon wird benutzt; sie werden über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>The {} bends by {} degrees, where the links around it let expect {} to {}. It is probably a cable or crosses a joint, or one of its cells is mounted otherwise.</source>
        <translation>Die {} ist um {} Grad gebogen, wo die Verbindungen ringsum {} bis {} erwarten lassen. Wahrscheinlich ist sie ein Kabel oder überquert ein Gelenk, oder eine ihrer Zellen ist anders montiert.</translation>
    </message>
    <message>
        <source>The {} is twisted by {} degrees, where the links around it let expect {} to {}. It is probably a cable, a port number is wrong, or one of its cells is mounted otherwise.</source>
        <translation>Die {} ist um {} Grad verwunden, wo die Verbindungen ringsum {} bis {} erwarten lassen. Wahrscheinlich ist sie ein Kabel, eine Portnummer ist falsch, oder eine ihrer Zellen ist anders montiert.</translation>
    </message>
    <message>
        <source>The {} is turned in the surface by {} degrees, where {} to {} are to be expected. A port number is probably wrong, it is a cable, or one of its cells is mounted otherwise.</source>
        <translation>Die {} ist in der Fläche um {} Grad gedreht, wo {} bis {} zu erwarten sind. Wahrscheinlich ist eine Portnummer falsch, sie ist ein Kabel, oder eine ihrer Zellen ist anders montiert.</translation>
    </message>
    <message>
        <source>Cell {} does not fit its neighbours well, and {} poses don&apos;t tell why. It is used; take another pose.</source>
        <translation>Zelle {} passt nicht gut zu ihren Nachbarn, und {} Posen sagen nicht, warum. Sie wird benutzt; eine weitere Pose aufnehmen.</translation>
    </message>
    <message>
        <source>Cell {} turned by {} degrees or more against the others before pose {}: it came loose or was fixed anew. It is placed through its links; take the poses before pose {} again.</source>
        <translation>Zelle {0} hat sich vor Pose {2} um mindestens {1} Grad gegen die anderen gedreht: Sie hat sich gelöst oder wurde neu befestigt. Sie wird über ihre Verbindungen verortet; die Posen vor Pose {3} noch einmal aufnehmen.</translation>
    </message>
    <message>
        <source>All links of the patch of cell {} are twisted one way, by {} degrees on the average, as on no surface: the axes of the accelerometers or the numbers of the ports are not as in the cell model {}.</source>
        <translation>Alle Verbindungen des Hautstücks von Zelle {} sind in eine Richtung verwunden, im Mittel um {} Grad, wie auf keiner Fläche: Die Achsen der Beschleunigungssensoren oder die Nummern der Ports sind nicht wie im Zellmodell {}.</translation>
    </message>
    <message>
        <source>The cells {} and {} fit into the skin with each other&apos;s readings, and not with their own: their cables or IDs are probably swapped. Both are placed through their links.</source>
        <translation>Die Zellen {} und {} passen mit den Messwerten der jeweils anderen in die Haut und nicht mit den eigenen: Wahrscheinlich sind ihre Kabel oder Nummern vertauscht. Beide werden über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Cell {} reads as if it were turned by {} degrees against its neighbours: it is mounted otherwise, or its axes are not as in the cell model. It is placed through its links.</source>
        <translation>Zelle {} misst, als wäre sie um {} Grad gegen ihre Nachbarn gedreht: Sie ist anders montiert, oder ihre Achsen sind nicht wie im Zellmodell. Sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>The links of a patch turn as on no surface: axes or ports are not as in the cell model.</source>
        <translation>Die Verbindungen eines Hautstücks sind verdreht wie auf keiner Fläche: Achsen oder Ports sind nicht wie im Zellmodell.</translation>
    </message>
    <message>
        <source>Cells read as if all of them were turned or mirrored alike against the others; their readings are turned back.</source>
        <translation>Zellen messen, als wären sie alle gleich gegen die anderen gedreht oder gespiegelt; ihre Messwerte werden zurückgedreht.</translation>
    </message>
    <message>
        <source>With one turn or reflection of their axes all links to the other cells are links of a skin.</source>
        <translation>Mit einer einzigen Drehung oder Spiegelung ihrer Achsen sind alle Verbindungen zu den anderen Zellen solche einer Haut.</translation>
    </message>
    <message>
        <source>Compare these cells with the others: how they are mounted, and of which batch they are.</source>
        <translation>Vergleichen Sie diese Zellen mit den anderen: wie sie montiert sind und aus welcher Charge sie stammen.</translation>
    </message>
    <message>
        <source>Nearly all links bend inwards: the skin lies in a hollow, or it comes out inside out.</source>
        <translation>Fast alle Verbindungen sind nach innen gebogen: Die Haut liegt in einer Höhlung, oder das Ergebnis ist umgestülpt.</translation>
    </message>
    <message>
        <source>A skin on the outside of a body bends outwards. Gravity cannot tell a hollow from a skin whose accelerometers are all mirrored.</source>
        <translation>Eine Haut außen auf einem Körper ist nach außen gebogen. Die Schwerkraft unterscheidet eine Höhlung nicht von einer Haut, deren Beschleunigungssensoren alle gespiegelt sind.</translation>
    </message>
    <message>
        <source>Say whether the skin lies on the outside of the body or in a hollow. On the outside, the axes of the accelerometers are not as in the cell model.</source>
        <translation>Geben Sie an, ob die Haut außen auf dem Körper oder in einer Höhlung liegt. Liegt sie außen, sind die Achsen der Beschleunigungssensoren nicht wie im Zellmodell.</translation>
    </message>
    <message>
        <source>{} of the {} cells read as if they were {} against the others: either these or the others are mounted otherwise, and readings alone leave open which. These are taken as turned.</source>
        <translation>{} der {} Zellen messen, als wären sie gegen die anderen {}: Entweder sind diese oder die anderen anders montiert, und die Messwerte allein lassen offen, welche. Diese gelten als gedreht.</translation>
    </message>
    <message>
        <source>{} of the {} cells read as if they were {} against the others: they are mounted otherwise, or of another batch. Their readings are turned back.</source>
        <translation>{} der {} Zellen messen, als wären sie gegen die anderen {}: Sie sind anders montiert oder aus einer anderen Charge. Ihre Messwerte werden zurückgedreht.</translation>
    </message>
    <message>
        <source>mirrored along x, y and z</source>
        <translation>entlang x, y und z gespiegelt</translation>
    </message>
    <message>
        <source>mirrored along {}</source>
        <translation>entlang {} gespiegelt</translation>
    </message>
    <message>
        <source>mirrored, {} and {} exchanged</source>
        <translation>gespiegelt, {} und {} vertauscht</translation>
    </message>
    <message>
        <source>mirrored, with axes exchanged</source>
        <translation>gespiegelt, mit vertauschten Achsen</translation>
    </message>
    <message>
        <source>turned by {} degrees, axes exchanged</source>
        <translation>um {} Grad gedreht, mit vertauschten Achsen</translation>
    </message>
    <message>
        <source>turned by {} degrees about {}</source>
        <translation>um {} Grad um {} gedreht</translation>
    </message>
    <message>
        <source>if the accelerometers are {}</source>
        <translation>wenn die Beschleunigungssensoren {} sind</translation>
    </message>
    <message>
        <source>if the ports are numbered {} further on</source>
        <translation>wenn die Ports um {} weiter nummeriert sind</translation>
    </message>
    <message>
        <source>The links of the patch of cell {} are turned as on no surface: the axes of the accelerometers or the numbers of the ports are not as in the cell model {}. All links fit, for example, {}. No other fault was looked for.</source>
        <translation>Die Verbindungen des Hautstücks von Zelle {} sind verdreht wie auf keiner Fläche: Die Achsen der Beschleunigungssensoren oder die Nummern der Ports sind nicht wie im Zellmodell {}. Alle Verbindungen passen zum Beispiel, {}. Nach anderen Fehlern wurde nicht gesucht.</translation>
    </message>
    <message>
        <source>The links of the patch of cell {} are turned as on no surface: the axes of the accelerometers or the numbers of the ports are not as in the cell model {}. No other fault was looked for.</source>
        <translation>Die Verbindungen des Hautstücks von Zelle {} sind verdreht wie auf keiner Fläche: Die Achsen der Beschleunigungssensoren oder die Nummern der Ports sind nicht wie im Zellmodell {}. Nach anderen Fehlern wurde nicht gesucht.</translation>
    </message>
    <message>
        <source>Of {} links that bend clearly, {} bend inwards. If the skin lies in a hollow, the result is right. If it lies on the outside of the body, the accelerometers are mirrored and the result is inside out: gravity cannot tell. Say where it lies.</source>
        <translation>Von {} deutlich gebogenen Verbindungen sind {} nach innen gebogen. Liegt die Haut in einer Höhlung, ist das Ergebnis richtig. Liegt sie außen auf dem Körper, sind die Beschleunigungssensoren gespiegelt und das Ergebnis ist umgestülpt: Die Schwerkraft zeigt das nicht. Geben Sie an, wo sie liegt.</translation>
    </message>
    <message>
        <source>Of {} links that bend clearly, {} bend inwards, and the skin is said to lie on the outside of the body: the axes of the accelerometers are not as in the cell model {}, and the result is inside out.</source>
        <translation>Von {} deutlich gebogenen Verbindungen sind {} nach innen gebogen, obwohl die Haut außen auf dem Körper liegen soll: Die Achsen der Beschleunigungssensoren sind nicht wie im Zellmodell {}, und das Ergebnis ist umgestülpt.</translation>
    </message>
    <message>
        <source>Of {} links that bend clearly, {} bend outwards, and the skin is said to lie in a hollow: the axes of the accelerometers are not as in the cell model {}, and the result is inside out.</source>
        <translation>Von {} deutlich gebogenen Verbindungen sind {} nach außen gebogen, obwohl die Haut in einer Höhlung liegen soll: Die Achsen der Beschleunigungssensoren sind nicht wie im Zellmodell {}, und das Ergebnis ist umgestülpt.</translation>
    </message>
    <message>
        <source>can&apos;t be told: its readings were turned back when it was calibrated</source>
        <translation>nicht zu sagen: Ihre Messwerte wurden bei der Kalibrierung zurückgedreht</translation>
    </message>
    <message>
        <source>Cells report the same readings, bit for bit; they are placed through their links.</source>
        <translation>Zellen melden Bit für Bit dieselben Messwerte; sie werden über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>Two neighbours fit with each other&apos;s readings; they are placed through their links.</source>
        <translation>Zwei Nachbarn passen mit den Messwerten der jeweils anderen; sie werden über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s readings are those of a cell that lies otherwise; it is placed through its links.</source>
        <translation>Die Messwerte einer Zelle sind die einer Zelle, die anders liegt; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell turned against the others between two poses; it is placed through its links.</source>
        <translation>Eine Zelle hat sich zwischen zwei Posen gegen die anderen gedreht; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>A cell&apos;s readings fit badly, and there are too few poses to say why; they are used.</source>
        <translation>Die Messwerte einer Zelle passen schlecht, und es sind zu wenige Posen, um zu sagen, warum; sie werden benutzt.</translation>
    </message>
    <message>
        <source>what limits a result</source>
        <translation>was ein Ergebnis begrenzt</translation>
    </message>
    <message>
        <source>what helps a result</source>
        <translation>was einem Ergebnis hilft</translation>
    </message>
    <message>
        <source>No cell is linked to another: nothing says how the {} cells lie.</source>
        <translation>Keine Zelle ist mit einer anderen verbunden: Nichts verrät, wie die {} Zellen liegen.</translation>
    </message>
    <message>
        <source>{} of {} cells are linked to no other: nothing says how they lie.</source>
        <translation>{} von {} Zellen sind mit keiner anderen verbunden: Nichts verrät, wie sie liegen.</translation>
    </message>
    <message>
        <source>Check the links between the cells, then the findings.</source>
        <translation>Erst die Verbindungen zwischen den Zellen prüfen, dann die Befunde.</translation>
    </message>
    <message>
        <source>Not enough: no pose yet. The shape shown follows from the ports alone.</source>
        <translation>Nicht genug: noch keine Pose. Die gezeigte Form folgt allein aus den Ports.</translation>
    </message>
    <message>
        <source>What limits it is that {} can&apos;t be used in {}: the readings are missing or no good.</source>
        <translation>Begrenzt wird das Ergebnis dadurch, dass {} in {} nicht zu brauchen ist: Die Messwerte fehlen oder taugen nichts.</translation>
    </message>
    <message>
        <source>The joint estimate of a patch ended before its optimum; placements and stated uncertainties are preliminary.</source>
        <translation>Die gemeinsame Schätzung eines Hautstücks endete vor ihrem Optimum; Lagen und angegebene Unsicherheiten sind vorläufig.</translation>
    </message>
    <message>
        <source>The estimate goes on in steps as long as they make the shape more probable, and the steps ran out.</source>
        <translation>Die Schätzung geht in Schritten weiter, solange sie die Form wahrscheinlicher machen, und die Schritte gingen aus.</translation>
    </message>
    <message>
        <source>Take another pose: two alone often leave open where the optimum is. Until then rely on no figure of this patch.</source>
        <translation>Eine weitere Pose aufnehmen: Zwei allein lassen oft offen, wo das Optimum liegt. Bis dahin ist auf keine Angabe zu diesem Hautstück Verlass.</translation>
    </message>
    <message>
        <source>The joint estimate of the patch of cell {} has not converged after {} steps: a more probable shape is nearby, and the stated uncertainty can&apos;t be relied on. Take another pose.</source>
        <translation>Die gemeinsame Schätzung des Hautstücks von Zelle {} ist nach {} Schritten nicht konvergiert: Eine wahrscheinlichere Form liegt in der Nähe, und auf die angegebene Unsicherheit ist kein Verlass. Nehmen Sie eine weitere Pose auf.</translation>
    </message>
    <message>
        <source>What limits it is how the cells lie in the mould: another pose would hardly help.</source>
        <translation>Begrenzt wird das Ergebnis dadurch, wie die Zellen in der Form liegen: Eine weitere Pose würde kaum helfen.</translation>
    </message>
    <message>
        <source>No used link joins the {} patches: each lies in the frame of its own origin.</source>
        <translation>Keine benutzte Verbindung verbindet die {} Hautstücke: Jedes liegt im Koordinatensystem seines eigenen Ursprungs.</translation>
    </message>
    <message>
        <source>poses {}</source>
        <translation>Posen {}</translation>
    </message>
    <message>
        <source>Look at the findings and check the links between the cells.</source>
        <translation>Die Befunde ansehen und die Verbindungen zwischen den Zellen prüfen.</translation>
    </message>
    <message>
        <source>The directions of gravity that were seen leave open how the cells are turned: take a pose in which the part is turned by about 90 degrees about a horizontal axis.</source>
        <translation>Die gesehenen Richtungen der Schwerkraft lassen offen, wie die Zellen gedreht sind: eine Pose aufnehmen, in der das Teil um etwa 90 Grad um eine waagrechte Achse gedreht ist.</translation>
    </message>
    <message>
        <source>at most offset_sigma_g, of which it is a part: {}</source>
        <translation>höchstens offset_sigma_g, dessen Teil es ist: {}</translation>
    </message>
    <message>
        <source>Other chips are on the skin than the model is about, or it is too sure of them: the estimate and its uncertainty suffer. Estimate the sigmas (hexoderm-cli sensors) and use the cell model that comes out.</source>
        <translation>Auf der Haut sitzen andere Chips als die, von denen das Modell handelt, oder es traut ihnen zu viel zu: Darunter leiden die Schätzung und ihre Unsicherheit. Schätzen Sie die Standardabweichungen (hexoderm-cli sensors) und verwenden Sie das Zellmodell, das dabei entsteht.</translation>
    </message>
    <message>
        <source>The offsets of {} accelerometers spread by about {} (1 sigma), and the cell model says {}.</source>
        <translation>Die Nullpunktfehler von {} Beschleunigungssensoren streuen um etwa {} (1 Sigma); das Zellmodell nennt {}.</translation>
    </message>
    <message>
        <source>The scale errors of {} accelerometers spread by about {} % (1 sigma), and the cell model says {} %.</source>
        <translation>Die Skalenfehler von {} Beschleunigungssensoren streuen um etwa {} % (1 Sigma); das Zellmodell nennt {} %.</translation>
    </message>
    <message>
        <source>The cross-axis sensitivities of {} accelerometers spread by about {} % (1 sigma), and the cell model says {} %.</source>
        <translation>Die Querempfindlichkeiten von {} Beschleunigungssensoren streuen um etwa {} % (1 Sigma); das Zellmodell nennt {} %.</translation>
    </message>
    <message>
        <source>there is no session to estimate sensors from</source>
        <translation>es gibt keine Sitzung, aus der die Sensoren geschätzt werden könnten</translation>
    </message>
    <message>
        <source>the sessions must have one cell model, and those of session {} and session 1 ({} and {}) differ</source>
        <translation>die Sitzungen müssen ein gemeinsames Zellmodell haben; die der Sitzungen {} und 1 ({} und {}) unterscheiden sich</translation>
    </message>
    <message>
        <source>The errors of the accelerometers are together clearly larger than the cell model&apos;s sigmas.</source>
        <translation>Die Fehler der Beschleunigungssensoren sind insgesamt deutlich größer als die Standardabweichungen des Zellmodells.</translation>
    </message>
    <message>
        <source>links for every cell and sensor, or one for the patch, for ROS</source>
        <translation>Glieder für jede Zelle und jeden Sensor oder eines für das Hautstück, für ROS</translation>
    </message>
    <message>
        <source>{} has one frame, and how the patches lie to each other is not known: write each to a file of its own</source>
        <translation>{} hat ein einziges Koordinatensystem, und wie die Hautstücke zueinander liegen, ist nicht bekannt: jedes in eine eigene Datei schreiben</translation>
    </message>
    <message>
        <source>no patch holds a cell {}</source>
        <translation>kein Hautstück enthält eine Zelle {}</translation>
    </message>
    <message>
        <source>all_patches: patch asks for one of them</source>
        <translation>all_patches: patch verlangt eines davon</translation>
    </message>
    <message>
        <source>Not in the file: the patch of cell {} ({}), because how it lies to the exported patch is not known.</source>
        <translation>Nicht in der Datei: das Hautstück der Zelle {} ({}), weil nicht bekannt ist, wie es zum exportierten Hautstück liegt.</translation>
    </message>
    <message>
        <source>Not in the file: the patches of cells {} ({}), because how they lie to the exported patch is not known.</source>
        <translation>Nicht in der Datei: die Hautstücke der Zellen {} ({}), weil nicht bekannt ist, wie sie zum exportierten Hautstück liegen.</translation>
    </message>
    <message>
        <source>Not in the file: {} patches ({}), because how they lie to the exported patch is not known.</source>
        <translation>Nicht in der Datei: {} Hautstücke ({}), weil nicht bekannt ist, wie sie zum exportierten Hautstück liegen.</translation>
    </message>
    <message>
        <source>only broken messages ({}) for {}; reconnecting in {}</source>
        <translation>seit {1} nur kaputte Nachrichten ({0}); neue Verbindung in {2}</translation>
    </message>
    <message>
        <source>nothing came for {}; reconnecting in {}</source>
        <translation>seit {} kam nichts; neue Verbindung in {}</translation>
    </message>
    <message>
        <source>{}; trying again</source>
        <translation>{}; neuer Versuch läuft</translation>
    </message>
    <message>
        <source>measured distance: expected metres above 0</source>
        <translation>gemessener Abstand: erwartet sind Meter über 0</translation>
    </message>
    <message>
        <source>a distance is between two different cells</source>
        <translation>ein Abstand liegt zwischen zwei verschiedenen Zellen</translation>
    </message>
    <message>
        <source>no link joins the patches of cells {} and {}: their distance is not known</source>
        <translation>keine Verbindung verbindet die Hautstücke der Zellen {} und {}: Ihr Abstand ist nicht bekannt</translation>
    </message>
    <message>
        <source>Look for the missing link, or export patch by patch.</source>
        <translation>Nach der fehlenden Verbindung suchen oder Hautstück für Hautstück exportieren.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is none of its values</source>
        <translation>„{}“ ist keiner der möglichen Werte</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>mm or m; STL itself has no unit</source>
        <translation>mm oder m; STL selbst hat keine Einheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>URDF of the robot</source>
        <translation>URDF des Roboters</translation>
    </message>
    <message>
        <source>URDF of the robot that gets the skin</source>
        <translation>URDF des Roboters, der die Haut bekommt</translation>
    </message>
    <message>
        <source>Name of the model</source>
        <translation>Name des Modells</translation>
    </message>
    <message>
        <source>Parent link</source>
        <translation>Elternglied</translation>
    </message>
    <message>
        <source>Link that a patch is fixed to whose place is not known</source>
        <translation>Glied, an dem ein Hautstück befestigt wird, dessen Ort nicht bekannt ist</translation>
    </message>
    <message>
        <source>Prefix of names</source>
        <translation>Namensvorsatz</translation>
    </message>
    <message>
        <source>Prefix of the names of links, joints and frames</source>
        <translation>Vorsatz der Namen von Gliedern, Gelenken und Koordinatensystemen</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>One link or frame per cell and sensor, or one per patch</source>
        <translation>Ein Glied oder Koordinatensystem je Zelle und Sensor, oder eines je Hautstück</translation>
    </message>
    <message>
        <source>One for each cell</source>
        <translation>Eines je Zelle</translation>
    </message>
    <message>
        <source>One for the patch (lighter in RViz)</source>
        <translation>Eines für das Hautstück (leichter in RViz)</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>alone: loads by itself; part: to be included in a robot that has the parent link; xacro: a macro for each patch</source>
        <translation>alone: lässt sich allein laden; part: zum Einbinden in einen Roboter, der das Elternglied hat; xacro: ein Makro je Hautstück</translation>
    </message>
    <message>
        <source>Loads by itself</source>
        <translation>Lässt sich allein laden</translation>
    </message>
    <message>
        <source>Part of a robot, without the parent link</source>
        <translation>Teil eines Roboters, ohne das Elternglied</translation>
    </message>
    <message>
        <source>xacro macro for each patch</source>
        <translation>xacro-Makro je Hautstück</translation>
    </message>
    <message>
        <source>no patch has cell {} as its origin</source>
        <translation>kein Hautstück hat Zelle {} als Ursprung</translation>
    </message>
    <message>
        <source>the patches are placed on {} links, and {} as asked for holds one, for how links lie to each other depends on the robot&apos;s joints: name one of them</source>
        <translation>die Hautstücke sitzen an {} Gliedern, und {} nimmt in dieser Form nur eines auf, denn wie Glieder zueinander liegen, hängt von den Gelenken des Roboters ab: nennen Sie eines davon</translation>
    </message>
    <message>
        <source>{} holds each patch in a frame of its own, not in that of a link</source>
        <translation>{} enthält jedes Hautstück in einem eigenen Koordinatensystem, nicht in dem eines Gliedes</translation>
    </message>
    <message>
        <source>no exported patch is placed on link {}</source>
        <translation>keines der zu exportierenden Hautstücke sitzt an Glied {}</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is no name for a xacro macro: leave out the /</source>
        <translation>„{}“ ist kein Name für ein xacro-Makro: lassen Sie den / weg</translation>
    </message>
    <message>
        <source>already has a {} {}: if this is an earlier skin, give the robot&apos;s own file, else choose another prefix of names</source>
        <translation>{} {} gibt es dort schon: ist das eine frühere Haut, geben Sie die Datei des Roboters selbst an, sonst wählen Sie einen anderen Namensvorsatz</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>expected an end tag &lt;/robot&gt;, but there is none</source>
        <translation>erwartet wird ein End-Tag &lt;/robot&gt;, es gibt aber keines</translation>
    </message>
    <message>
        <source>A DOT file is a flat drawing without places and uncertainties.</source>
        <translation>Eine DOT-Datei ist eine flache Zeichnung ohne Lagen und Unsicherheiten.</translation>
    </message>
    <message>
        <source>A PLY file holds no sensors and no uncertainties.</source>
        <translation>Eine PLY-Datei enthält keine Sensoren und keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>An STL file holds no IDs, colours, sensors and uncertainties.</source>
        <translation>Eine STL-Datei enthält keine Nummern, Farben, Sensoren und Unsicherheiten.</translation>
    </message>
    <message>
        <source>A VTP file holds no links between cells.</source>
        <translation>Eine VTP-Datei enthält keine Verbindungen zwischen den Zellen.</translation>
    </message>
    <message>
        <source>A URDF holds no uncertainties.</source>
        <translation>Ein URDF enthält keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>the robot&apos;s own URDF, unchanged, with the skin on its links</source>
        <translation>das URDF des Roboters selbst, unverändert, mit der Haut an seinen Gliedern</translation>
    </message>
    <message>
        <source>static transforms of all frames, a ROS 1 launch file</source>
        <translation>feste Transformationen aller Koordinatensysteme, als Launch-Datei für ROS 1</translation>
    </message>
    <message>
        <source>Static transforms hold no shapes and no uncertainties.</source>
        <translation>Feste Transformationen enthalten keine Formen und keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>static transforms of all frames, a ROS 2 launch file</source>
        <translation>feste Transformationen aller Koordinatensysteme, als Launch-Datei für ROS 2</translation>
    </message>
    <message>
        <source>static transforms of all frames, TransformStamped in YAML</source>
        <translation>feste Transformationen aller Koordinatensysteme, TransformStamped in YAML</translation>
    </message>
    <message>
        <source>SkinConfig of the TUM skin&apos;s own software</source>
        <translation>SkinConfig der Software zur TUM-Haut</translation>
    </message>
    <message>
        <source>A SkinConfig holds no sensors, no uncertainties, and not the port of the computer.</source>
        <translation>Eine SkinConfig enthält keine Sensoren, keine Unsicherheiten und nicht den Anschluss des Rechners.</translation>
    </message>
    <message>
        <source>taxel positions as iCub reads them, a taxel for each cell</source>
        <translation>Taxelpositionen, wie iCub sie liest, ein Taxel je Zelle</translation>
    </message>
    <message>
        <source>Taxel positions are centres and normals of the cells, without IDs, turns about the normal and uncertainties.</source>
        <translation>Taxelpositionen sind Mittelpunkte und Normalen der Zellen, ohne Nummern, Drehungen um die Normale und Unsicherheiten.</translation>
    </message>
    <message>
        <source>map of the cells for Skinware (CySkin)</source>
        <translation>Karte der Zellen für Skinware (CySkin)</translation>
    </message>
    <message>
        <source>A Skinware map holds centres and normals of the cells, without turns about the normal and uncertainties.</source>
        <translation>Eine Skinware-Karte enthält Mittelpunkte und Normalen der Zellen, ohne Drehungen um die Normale und Unsicherheiten.</translation>
    </message>
    <message>
        <source>mesh of the cells in metres, an object for each cell</source>
        <translation>Netz der Zellen in Metern, ein Objekt je Zelle</translation>
    </message>
    <message>
        <source>An OBJ file holds no sensors and no uncertainties.</source>
        <translation>Eine OBJ-Datei enthält keine Sensoren und keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>scene with a node for each cell and sensor (glTF 2.0)</source>
        <translation>Szene mit einem Knoten je Zelle und Sensor (glTF 2.0)</translation>
    </message>
    <message>
        <source>A glTF scene holds no uncertainties.</source>
        <translation>Eine glTF-Szene enthält keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>model for Gazebo, with a frame for each cell and sensor</source>
        <translation>Modell für Gazebo, mit einem Koordinatensystem je Zelle und Sensor</translation>
    </message>
    <message>
        <source>An SDF model holds no uncertainties; the skin&apos;s mass is not known, and 1 g stands for it.</source>
        <translation>Ein SDF-Modell enthält keine Unsicherheiten; die Masse der Haut ist nicht bekannt, und 1 g steht dafür.</translation>
    </message>
    <message>
        <source>model for MuJoCo, with a site for each sensor</source>
        <translation>Modell für MuJoCo, mit einer Stelle („site“) je Sensor</translation>
    </message>
    <message>
        <source>An MJCF model holds no uncertainties and no mass of the skin.</source>
        <translation>Ein MJCF-Modell enthält keine Unsicherheiten und keine Masse der Haut.</translation>
    </message>
    <message>
        <source>expected finite numbers for the patch of cell {}</source>
        <translation>erwartet werden endliche Zahlen für das Hautstück der Zelle {}</translation>
    </message>
    <message>
        <source>the patch of cell {} is placed twice</source>
        <translation>das Hautstück der Zelle {} ist zweimal platziert</translation>
    </message>
    <message>
        <source>expected the URDF of the robot that gets the skin</source>
        <translation>erwartet wird das URDF des Roboters, der die Haut bekommt</translation>
    </message>
    <message>
        <source>Not in the file: the patch of cell {} ({}), because it is not placed on a link that the file holds.</source>
        <translation>Nicht in der Datei: das Hautstück der Zelle {} ({}), weil es an keinem Glied sitzt, das die Datei enthält.</translation>
    </message>
    <message>
        <source>Not in the file: {} patches ({}), because they are not placed on a link that the file holds.</source>
        <translation>Nicht in der Datei: {} Hautstücke ({}), weil sie an keinem Glied sitzen, das die Datei enthält.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is also the name of a link of the skin</source>
        <translation>„{}“ ist auch der Name eines Gliedes der Haut</translation>
    </message>
    <message>
        <source>simulated robot: {} must not be negative</source>
        <translation>Simulierter Roboter: {} darf nicht negativ sein</translation>
    </message>
    <message>
        <source>simulated robot: range_share must be from 0 to 1</source>
        <translation>Simulierter Roboter: range_share muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>simulated robot: expected at least one patch on a link</source>
        <translation>Simulierter Roboter: Mindestens ein Hautstück auf einem Glied wird erwartet</translation>
    </message>
    <message>
        <source>{} on {}</source>
        <translation>{} auf {}</translation>
    </message>
    <message>
        <source>Simulated robot {} on a fixed base: {}, seed {}</source>
        <translation>Simulierter Roboter {} auf fester Basis: {}, Startwert {}</translation>
    </message>
    <message>
        <source>Simulated robot {} in a hand: {}, seed {}</source>
        <translation>Simulierter Roboter {} in einer Hand: {}, Startwert {}</translation>
    </message>
    <message>
        <source>there is no message of type {}; expected 1 to 7</source>
        <translation>Eine Nachricht vom Typ {} gibt es nicht; erwartet: 1 bis 7</translation>
    </message>
    <message>
        <source>expected 1 to {} numbers, found {}</source>
        <translation>1 bis {} Zahlen werden erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>expected the name of a joint, found nothing</source>
        <translation>Der Name eines Gelenks wird erwartet, gefunden wurde nichts</translation>
    </message>
    <message>
        <source>expected each joint once</source>
        <translation>Jedes Gelenk wird nur einmal erwartet</translation>
    </message>
    <message>
        <source>expected finite numbers, at most {}</source>
        <translation>Endliche Zahlen bis höchstens {} werden erwartet</translation>
    </message>
    <message>
        <source>expected a number for each of {} joints that were named, found {}</source>
        <translation>Eine Zahl für jedes der {} genannten Gelenke wird erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>the body has no surface on which a patch could lie</source>
        <translation>Der Körper hat keine Oberfläche, auf der ein Hautstück liegen könnte</translation>
    </message>
    <message>
        <source>the patch can&apos;t be laid there: its x axis would stand upright on the body</source>
        <translation>Dort kann das Hautstück nicht liegen: Seine x-Achse stünde senkrecht auf dem Körper</translation>
    </message>
    <message>
        <source>the demo robot is not installed: there is no {}</source>
        <translation>Der Demo-Roboter ist nicht installiert: Es fehlt {}</translation>
    </message>
    <message>
        <source>a joint&apos;s position needs the name of the joint</source>
        <translation>Zur Stellung eines Gelenks gehört dessen Name</translation>
    </message>
    <message>
        <source>joint {}: expected a finite position, at most {}</source>
        <translation>Gelenk {}: Eine endliche Stellung bis höchstens {} wird erwartet</translation>
    </message>
    <message>
        <source>the table is too large</source>
        <translation>Die Tabelle ist zu groß</translation>
    </message>
    <message>
        <source>expected a line for each pose, but there is none</source>
        <translation>Eine Zeile für jede Pose wird erwartet, es gibt aber keine</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>Spalte {}</translation>
    </message>
    <message>
        <source>expected the unit of the angles, deg or rad, found {}</source>
        <translation>Die Einheit der Winkel, deg oder rad, wird erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>expected the unit above the line with the names of the joints</source>
        <translation>Die Einheit wird über der Zeile mit den Namen der Gelenke erwartet</translation>
    </message>
    <message>
        <source>expected fields separated by commas; a quote is not closed</source>
        <translation>Durch Kommas getrennte Felder werden erwartet; ein Anführungszeichen ist nicht geschlossen</translation>
    </message>
    <message>
        <source>is empty; expected a line with the names of the joints</source>
        <translation>ist leer; eine Zeile mit den Namen der Gelenke wird erwartet</translation>
    </message>
    <message>
        <source>there are more than {} columns</source>
        <translation>Es gibt mehr als {} Spalten</translation>
    </message>
    <message>
        <source>joint {} has a column already</source>
        <translation>Gelenk {} hat schon eine Spalte</translation>
    </message>
    <message>
        <source>expected one column pose or time, this is a second one</source>
        <translation>Eine einzige Spalte „pose“ oder „time“ wird erwartet, dies ist eine zweite</translation>
    </message>
    <message>
        <source>expected a column pose (the poses&apos; numbers) or time (s since 1970, UTC)</source>
        <translation>Eine Spalte „pose“ (Nummern der Posen) oder „time“ (s seit 1970, UTC) wird erwartet</translation>
    </message>
    <message>
        <source>these joints of the robot have no column: {}</source>
        <translation>Diese Gelenke des Roboters haben keine Spalte: {}</translation>
    </message>
    <message>
        <source>{} joints of the robot have no column, {} among them</source>
        <translation>{} Gelenke des Roboters haben keine Spalte, darunter {}</translation>
    </message>
    <message>
        <source>expected one for each joint that can move (0 where it did not)</source>
        <translation>Für jedes bewegliche Gelenk wird eine erwartet (0, wo es sich nicht bewegt hat)</translation>
    </message>
    <message>
        <source>expected the name of a joint above every column</source>
        <translation>Über jeder Spalte wird der Name eines Gelenks erwartet</translation>
    </message>
    <message>
        <source>this joint of the robot is fixed and has no angle</source>
        <translation>Dieses Gelenk des Roboters ist fest und hat keinen Winkel</translation>
    </message>
    <message>
        <source>the robot {} has no joint {}</source>
        <translation>Der Roboter {} hat kein Gelenk {}</translation>
    </message>
    <message>
        <source>columns of anything else have to be taken out</source>
        <translation>Spalten mit anderem müssen entfernt werden</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>Ist {} gemeint?</translation>
    </message>
    <message>
        <source>expected the unit deg or rad, found {}</source>
        <translation>Die Einheit deg oder rad wird erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>expected the unit m or mm, found {}</source>
        <translation>Die Einheit m oder mm wird erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>expected the unit s, ms, us or ns, found {}</source>
        <translation>Die Einheit s, ms, us oder ns wird erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>expected the unit in the title, as in lift[m]</source>
        <translation>Die Einheit wird im Titel erwartet, wie in lift[m]</translation>
    </message>
    <message>
        <source>expected the unit in the title, as in {}[deg] or {}[rad], or a first line &quot;# unit: deg&quot;</source>
        <translation>Die Einheit wird im Titel erwartet, wie in {}[deg] oder {}[rad], oder eine erste Zeile „# unit: deg“</translation>
    </message>
    <message>
        <source>expected {} columns as in the first line, found {}</source>
        <translation>{} Spalten wie in der ersten Zeile werden erwartet, gefunden: {}</translation>
    </message>
    <message>
        <source>{} is no joint&apos;s angle</source>
        <translation>{} ist kein Gelenkwinkel</translation>
    </message>
    <message>
        <source>expected a number, but there is none</source>
        <translation>Eine Zahl wird erwartet, es gibt aber keine</translation>
    </message>
    <message>
        <source>pose {} was given already, in line {}</source>
        <translation>Pose {} kam schon in Zeile {} vor</translation>
    </message>
    <message>
        <source>has angles of the poses {} to {}, but the session has the poses {} to {}</source>
        <translation>hat Winkel der Posen {} bis {}, aber die Sitzung hat die Posen {} bis {}</translation>
    </message>
    <message>
        <source>has times, but the poses of the session don&apos;t say when they were taken: expected a column pose</source>
        <translation>hat Zeiten, aber die Posen der Sitzung sagen nicht, wann sie aufgenommen wurden: Eine Spalte pose wird erwartet</translation>
    </message>
    <message>
        <source>no time is within a second of a pose: the file goes from {} to {}, and the poses were taken from {} to {} (s since 1970, UTC)</source>
        <translation>Keine Zeit liegt näher als eine Sekunde an einer Pose: Die Datei geht von {} bis {}, und die Posen wurden von {} bis {} aufgenommen (s seit 1970, UTC)</translation>
    </message>
    <message>
        <source>expected times that ascend; {} does not</source>
        <translation>Aufsteigende Zeiten werden erwartet; {} ist nicht größer als die vorige</translation>
    </message>
    <message>
        <source>Joint {} is at {}; its limits are {} and {}.</source>
        <translation>Gelenk {} steht bei {}; seine Grenzen sind {} und {}.</translation>
    </message>
    <message>
        <source>These joint angles are probably degrees that were read as rad: {} of {} joints that turn are far beyond their limits, and as degrees none is. Joint {}, for example, has {}.</source>
        <translation>Diese Gelenkwinkel sind wahrscheinlich Grad, die als Radiant gelesen wurden: {} von {} Drehgelenken liegen weit außerhalb ihrer Grenzen, in Grad keines. Gelenk {} zum Beispiel hat {}.</translation>
    </message>
    <message>
        <source>there is no such mesh file</source>
        <translation>Diese Netzdatei gibt es nicht</translation>
    </message>
    <message>
        <source>expected a mesh file, but this is none</source>
        <translation>Eine Netzdatei wird erwartet, das ist aber keine</translation>
    </message>
    <message>
        <source>expected a mesh of triangles, but it has none</source>
        <translation>Ein Netz aus Dreiecken wird erwartet, es hat aber keine</translation>
    </message>
    <message>
        <source>has more than {} triangles</source>
        <translation>hat mehr als {} Dreiecke</translation>
    </message>
    <message>
        <source>this is no valid URDF; urdfdom says: {}</source>
        <translation>Das ist keine gültige URDF; urdfdom meldet: {}</translation>
    </message>
    <message>
        <source>link {}</source>
        <translation>Glied {}</translation>
    </message>
    <message>
        <source>joint {}</source>
        <translation>Gelenk {}</translation>
    </message>
    <message>
        <source>expected an axis, but its length is 0</source>
        <translation>Eine Achse wird erwartet, ihre Länge ist aber 0</translation>
    </message>
    <message>
        <source>expected limits of which the lower is not above the upper</source>
        <translation>Grenzen werden erwartet, deren untere nicht über der oberen liegt</translation>
    </message>
    <message>
        <source>Joint {} is a floating one; it is taken as fixed at its zero.</source>
        <translation>Gelenk {} ist frei beweglich; es wird als fest in seiner Nullstellung genommen.</translation>
    </message>
    <message>
        <source>Joint {} is a planar one; it is taken as fixed at its zero.</source>
        <translation>Gelenk {} ist in einer Ebene beweglich; es wird als fest in seiner Nullstellung genommen.</translation>
    </message>
    <message>
        <source>expected the type revolute, continuous, prismatic, fixed, floating or planar</source>
        <translation>Der Typ revolute, continuous, prismatic, fixed, floating oder planar wird erwartet</translation>
    </message>
    <message>
        <source>mimics joint {}, which is not among the robot&apos;s joints</source>
        <translation>folgt Gelenk {}, das der Roboter nicht hat</translation>
    </message>
    <message>
        <source>mimics joints that mimic each other in a circle</source>
        <translation>folgt Gelenken, die einander im Kreis folgen</translation>
    </message>
    <message>
        <source>the mesh {} can&apos;t be found: {}</source>
        <translation>Das Netz {} ist nicht zu finden: {}</translation>
    </message>
    <message>
        <source>say which folder is the package {}, as --package {}=FOLDER</source>
        <translation>Geben Sie den Ordner des Pakets {} an: --package {}=ORDNER</translation>
    </message>
    <message>
        <source>expected package://NAME/FILE, file:///FILE or a path</source>
        <translation>package://NAME/DATEI, file:///DATEI oder ein Pfad wird erwartet</translation>
    </message>
    <message>
        <source>the robot has no link {}</source>
        <translation>Der Roboter hat kein Glied {}</translation>
    </message>
    <message>
        <source>the robot has no joint {}</source>
        <translation>Der Roboter hat kein Gelenk {}</translation>
    </message>
    <message>
        <source>The body of link {} would be {} m long: its mesh is probably in millimetres, where a URDF needs metres. With a scale of 0.001 it would be {} long.</source>
        <translation>Der Körper von Glied {} wäre {} m lang: Sein Netz ist wahrscheinlich in Millimetern, wo eine URDF Meter braucht. Im Maßstab 0,001 wäre er {} lang.</translation>
    </message>
    <message>
        <source>The body of link {} would be only {} long: its mesh is probably scaled twice. With a scale 1000 times as large it would be {} long.</source>
        <translation>Der Körper von Glied {} wäre nur {} lang: Sein Netz ist wahrscheinlich zweimal verkleinert. In tausendfachem Maßstab wäre er {} lang.</translation>
    </message>
    <message>
        <source>this is not well-formed XML ({}; truncated?), expected a URDF</source>
        <translation>Das ist kein wohlgeformtes XML ({}; abgeschnitten?), erwartet wird eine URDF</translation>
    </message>
    <message>
        <source>expected a URDF, whose root element is &lt;robot&gt;, found &lt;{}&gt;</source>
        <translation>Eine URDF mit dem Wurzelelement &lt;robot&gt; wird erwartet, gefunden: &lt;{}&gt;</translation>
    </message>
    <message>
        <source>the elements are nested too deeply for a URDF</source>
        <translation>Die Elemente sind für eine URDF zu tief verschachtelt</translation>
    </message>
    <message>
        <source>{} is xacro, from which URDF is made: run xacro first, and open what it writes</source>
        <translation>{} ist xacro, woraus URDF erst entsteht: Rufen Sie zuerst xacro auf, und öffnen Sie dessen Ausgabe</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has no name</source>
        <translation>&lt;{}&gt; hat keinen Namen</translation>
    </message>
    <message>
        <source>there is a {} {} already, in line {}: expected each name once</source>
        <translation>Ein {} {} gibt es schon in Zeile {}: Jeder Name wird nur einmal erwartet</translation>
    </message>
    <message>
        <source>there are more than {} links</source>
        <translation>Es gibt mehr als {} Glieder</translation>
    </message>
    <message>
        <source>expected links, but the robot has none</source>
        <translation>Glieder werden erwartet, der Roboter hat aber keine</translation>
    </message>
    <message>
        <source>link {} has two parents, by the joints {} and {}: a URDF is a tree</source>
        <translation>Glied {} hat durch die Gelenke {} und {} zwei Eltern: Eine URDF ist ein Baum</translation>
    </message>
    <message>
        <source>no joint carries link {}, nor link {}: expected one root</source>
        <translation>Weder Glied {} noch Glied {} hängt an einem Gelenk: Nur eine Wurzel wird erwartet</translation>
    </message>
    <message>
        <source>the joints {} form a loop: a URDF is a tree, whose root no joint carries</source>
        <translation>Die Gelenke {} bilden eine Schleife: Eine URDF ist ein Baum, dessen Wurzel an keinem Gelenk hängt</translation>
    </message>
    <message>
        <source>the name of a joint</source>
        <translation>der Name eines Gelenks</translation>
    </message>
    <message>
        <source>a position of at most {}</source>
        <translation>eine Stellung von höchstens {}</translation>
    </message>
    <message>
        <source>each joint once</source>
        <translation>jedes Gelenk nur einmal</translation>
    </message>
    <message>
        <source>joint {} has no &lt;{} link=&quot;...&quot;&gt;</source>
        <translation>Gelenk {} hat kein &lt;{} link=&quot;...&quot;&gt;</translation>
    </message>
    <message>
        <source>joint {}: &lt;{} link=&quot;{}&quot;&gt; names none of the robot&apos;s links</source>
        <translation>Gelenk {}: &lt;{} link=&quot;{}&quot;&gt; nennt kein Glied des Roboters</translation>
    </message>
    <message>
        <source>broken: it reads the same as another cell, digit for digit</source>
        <translation>defekt: misst Ziffer für Ziffer dasselbe wie eine andere Zelle</translation>
    </message>
    <message>
        <source>dead: it reads no gravity</source>
        <translation>tot: misst keine Schwerkraft</translation>
    </message>
    <message>
        <source>dead: it reads the same in all poses</source>
        <translation>tot: misst in allen Posen dasselbe</translation>
    </message>
    <message>
        <source>broken: it reads the end of its range</source>
        <translation>defekt: misst das Ende ihres Messbereichs</translation>
    </message>
    <message>
        <source>broken: one of its axes is dead</source>
        <translation>defekt: eine ihrer Achsen ist tot</translation>
    </message>
    <message>
        <source>broken: it scatters far more than the other cells</source>
        <translation>defekt: streut weit mehr als die anderen Zellen</translation>
    </message>
    <message>
        <source>can&apos;t be told: no other cell of its patch can be compared with it</source>
        <translation>nicht zu sagen: Keine andere Zelle ihres Hautstücks lässt sich mit ihr vergleichen</translation>
    </message>
    <message>
        <source>can&apos;t be told: the cells of its patch contradict each other, and no majority agrees</source>
        <translation>nicht zu sagen: Die Zellen ihres Hautstücks widersprechen einander, und keine Mehrheit ist sich einig</translation>
    </message>
    <message>
        <source>gone: it is no longer among the skin&apos;s cells</source>
        <translation>fort: gehört nicht mehr zu den Zellen der Haut</translation>
    </message>
    <message>
        <source>can&apos;t be told: it has no usable reading, as when it was calibrated</source>
        <translation>nicht zu sagen: Sie hat keinen brauchbaren Messwert, wie schon beim Kalibrieren</translation>
    </message>
    <message>
        <source>dead: it sends no reading</source>
        <translation>tot: sendet keine Messwerte</translation>
    </message>
    <message>
        <source>can&apos;t be told: its calibration is too uncertain</source>
        <translation>nicht zu sagen: Ihre Kalibrierung ist zu unsicher</translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation>wie kalibriert</translation>
    </message>
    <message>
        <source>broken: neither a turn nor a drift of its offset explains what it reads</source>
        <translation>defekt: Weder eine Drehung noch eine Drift ihres Offsets erklärt, was sie misst</translation>
    </message>
    <message>
        <source>turned by {} +- {} or more</source>
        <translation>um {} ± {} oder mehr gedreht</translation>
    </message>
    <message>
        <source>turned by {} +- {}</source>
        <translation>um {} ± {} gedreht</translation>
    </message>
    <message>
        <source>its sensor&apos;s offset drifted by {} +- {}</source>
        <translation>der Offset ihres Sensors ist um {} ± {} gedriftet</translation>
    </message>
    <message>
        <source>changed: {}, or {}; these poses can&apos;t tell which</source>
        <translation>verändert: {}, oder {}; diese Posen können das nicht unterscheiden</translation>
    </message>
    <message>
        <source>The offsets of all sensors drifted together by {} +- {}; that is no change.</source>
        <translation>Die Offsets aller Sensoren sind gemeinsam um {} ± {} gedriftet; das ist keine Veränderung.</translation>
    </message>
    <message>
        <source>The {} of the calibration is no longer reported.</source>
        <translation>Nicht mehr gemeldet wird, was die Kalibrierung noch hat: {}.</translation>
    </message>
    <message>
        <source>Not as calibrated: {}.</source>
        <translation>Nicht wie kalibriert: {}.</translation>
    </message>
    <message>
        <source>Nothing could be compared: no two cells of a patch have a usable reading.</source>
        <translation>Es ließ sich nichts vergleichen: Kein Hautstück hat zwei Zellen mit einem brauchbaren Messwert.</translation>
    </message>
    <message>
        <source>The skin is not as calibrated, and the cells contradict each other so much that none can be named: calibrate it anew.</source>
        <translation>Die Haut ist nicht wie kalibriert, und die Zellen widersprechen einander so sehr, dass sich keine nennen lässt: neu kalibrieren.</translation>
    </message>
    <message>
        <source>All {} cells are as calibrated, as far as these poses show.</source>
        <translation>Alle {} Zellen sind wie kalibriert, soweit diese Posen es zeigen.</translation>
    </message>
    <message>
        <source>So many cells changed that the skin should be calibrated anew.</source>
        <translation>So viele Zellen haben sich verändert, dass die Haut neu kalibriert werden sollte.</translation>
    </message>
    <message>
        <source>These poses don&apos;t show every turn of a cell: take another one, with the part turned by 45° or more.</source>
        <translation>Diese Posen zeigen nicht jede Drehung einer Zelle: eine weitere aufnehmen, mit dem Körperteil um mindestens 45° gedreht.</translation>
    </message>
    <message>
        <source>the calibration was imported and does not say how its cells were measured: only one that Hexoderm made of poses can be checked</source>
        <translation>die Kalibrierung wurde importiert und sagt nicht, wie ihre Zellen gemessen wurden: Prüfen lässt sich nur eine, die Hexoderm aus Posen berechnet hat</translation>
    </message>
    <message>
        <source>there is no pose to check the calibration with: take one to three</source>
        <translation>es gibt keine Pose, mit der sich die Kalibrierung prüfen ließe: eine bis drei aufnehmen</translation>
    </message>
    <message>
        <source>the calibration is of another kind of cell: port {} of its cell model {} is not where the cell model {} has it</source>
        <translation>die Kalibrierung gehört zu einer anderen Art von Zelle: Port {} ihres Zellmodells {} liegt nicht dort, wo das Zellmodell {} ihn hat</translation>
    </message>
    <message>
        <source>the calibration is of another kind of cell: the ports or the accelerometer of its cell model {} are not those of the cell model {}</source>
        <translation>die Kalibrierung gehört zu einer anderen Art von Zelle: Ports oder Beschleunigungssensor ihres Zellmodells {} sind nicht die des Zellmodells {}</translation>
    </message>
    <message>
        <source>the calibration is of another skin: {} of today is not in it</source>
        <translation>die Kalibrierung gehört zu einer anderen Haut: {} von heute kommt darin nicht vor</translation>
    </message>
    <message>
        <source>one of the {}</source>
        <translation>eine von {}</translation>
    </message>
    <message>
        <source>the calibration is of another skin, or the cells were joined otherwise: {} is not in it</source>
        <translation>die Kalibrierung gehört zu einer anderen Haut, oder die Zellen wurden anders verbunden: {} kommt darin nicht vor</translation>
    </message>
    <message>
        <source>the calibration is of another skin: {} of its {} cells are not there today</source>
        <translation>die Kalibrierung gehört zu einer anderen Haut: {} ihrer {} Zellen sind heute nicht da</translation>
    </message>
    <message>
        <source>Nothing can be told of any cell: the calibration is too uncertain.</source>
        <translation>Über keine Zelle lässt sich etwas sagen: Die Kalibrierung ist zu unsicher.</translation>
    </message>
    <message>
        <source>{} of {} cells are as calibrated, as far as these poses show; of {} nothing can be told.</source>
        <translation>{} von {} Zellen sind wie kalibriert, soweit diese Posen es zeigen; über {} lässt sich nichts sagen.</translation>
    </message>
    <message>
        <source>urdfdom reads other links or joints in it than this program: an element or an attribute is probably malformed, or there twice</source>
        <translation>urdfdom liest darin andere Glieder oder Gelenke als dieses Programm: Wahrscheinlich ist ein Element oder Attribut fehlerhaft oder doppelt vorhanden</translation>
    </message>
    <message>
        <source>No single axis explains how the two parts turned against each other: there is more between them than one revolute joint, or a part moved while a pose was taken.</source>
        <translation>Keine einzelne Achse erklärt, wie sich die beiden Teile gegeneinander gedreht haben: Zwischen ihnen liegt mehr als ein Drehgelenk, oder ein Teil hat sich während einer Aufnahme bewegt.</translation>
    </message>
    <message>
        <source>Move one joint only, and take at least five poses with it.</source>
        <translation>Nur ein Gelenk bewegen und damit mindestens fünf Posen aufnehmen.</translation>
    </message>
    <message>
        <source>One axis explains all {} poses; it is known to {} in the one part and to {} in the other.</source>
        <translation>Eine Achse erklärt alle {} Posen; sie ist im einen Teil auf {} genau bekannt und im anderen auf {}.</translation>
    </message>
    <message>
        <source>Take another pose with the joint between them turned elsewhere and its axis pointing in a new direction.</source>
        <translation>Eine weitere Pose aufnehmen, in der das Gelenk dazwischen anders steht und seine Achse in eine neue Richtung zeigt.</translation>
    </message>
    <message>
        <source>The poses can be explained by several axes.</source>
        <translation>Die Posen lassen sich durch mehrere Achsen erklären.</translation>
    </message>
    <message>
        <source>The axis is known in one of the two parts only: in the other one, gravity came from nearly one direction in all poses.</source>
        <translation>Die Achse ist nur in einem der beiden Teile bekannt: Im anderen kam die Schwerkraft in allen Posen etwa aus derselben Richtung.</translation>
    </message>
    <message>
        <source>The poses leave open where the axis is.</source>
        <translation>Die Posen lassen offen, wo die Achse liegt.</translation>
    </message>
    <message>
        <source>An axis between two parts takes at least {} poses, and there are {}.</source>
        <translation>Für eine Achse zwischen zwei Teilen braucht es mindestens {} Posen, vorhanden sind {}.</translation>
    </message>
    <message>
        <source>Take more poses, each with the joint turned elsewhere.</source>
        <translation>Mehr Posen aufnehmen, jede mit dem Gelenk in einer anderen Stellung.</translation>
    </message>
    <message>
        <source>Which patches move together can be told of a session that was just solved by the global solver, not of a calibration file or of the tree: they don&apos;t hold how well gravity is known.</source>
        <translation>Welche Hautstücke sich gemeinsam bewegen, lässt sich nur für eine eben mit dem globalen Löser gelöste Sitzung sagen, nicht für eine Kalibrierungsdatei oder den Baum: Diese enthalten nicht, wie genau die Schwerkraft bekannt ist.</translation>
    </message>
    <message>
        <source>The part of cell {} and the part of cell {} turned against each other.</source>
        <translation>Der Teil mit Zelle {} und der Teil mit Zelle {} haben sich gegeneinander gedreht.</translation>
    </message>
    <message>
        <source>Whether the part of cell {} and that of cell {} move together can&apos;t be told: fewer than two poses have readings of both.</source>
        <translation>Ob sich der Teil mit Zelle {} und der mit Zelle {} gemeinsam bewegen, lässt sich nicht sagen: In weniger als zwei Posen gibt es Messwerte von beiden.</translation>
    </message>
    <message>
        <source>Take poses in which the cells of both have readings.</source>
        <translation>Posen aufnehmen, in denen die Zellen beider Teile Messwerte haben.</translation>
    </message>
    <message>
        <source>Whether the part of cell {} and that of cell {} move together can&apos;t be told: gravity came along one line in all poses, and a turn about that line doesn&apos;t show.</source>
        <translation>Ob sich der Teil mit Zelle {} und der mit Zelle {} gemeinsam bewegen, lässt sich nicht sagen: Die Schwerkraft lag in allen Posen auf einer Geraden, und eine Drehung um diese Gerade zeigt sich nicht.</translation>
    </message>
    <message>
        <source>Take poses in which the parts are tipped over by about 90 degrees.</source>
        <translation>Posen aufnehmen, in denen die Teile um etwa 90 Grad gekippt sind.</translation>
    </message>
    <message>
        <source>Whether the part of cell {} and that of cell {} move together can&apos;t be told: in all {} poses they fit one rotation, but a joint between them could have been moved without showing.</source>
        <translation>Ob sich der Teil mit Zelle {} und der mit Zelle {} gemeinsam bewegen, lässt sich nicht sagen: In allen {} Posen passt zu ihnen eine einzige Drehung, aber ein Gelenk dazwischen könnte unbemerkt bewegt worden sein.</translation>
    </message>
    <message>
        <source>Take more poses: move the joint that may be between them by 30 degrees or more from pose to pose, and tip the parts over in new directions.</source>
        <translation>Weitere Posen aufnehmen: das mögliche Gelenk dazwischen von Pose zu Pose um mindestens 30 Grad bewegen und die Teile in neue Richtungen kippen.</translation>
    </message>
    <message>
        <source>No patch saw gravity: there is nothing to compare.</source>
        <translation>Kein Hautstück hat die Schwerkraft gemessen: Es gibt nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>There is one patch: nothing to compare it with.</source>
        <translation>Es gibt nur ein Hautstück, also nichts, womit es sich vergleichen ließe.</translation>
    </message>
    <message>
        <source>All {} patches move together, as far as these poses show: a joint that stood still in all of them can&apos;t be seen.</source>
        <translation>Alle {} Hautstücke bewegen sich gemeinsam, soweit diese Posen das zeigen: Ein Gelenk, das in allen stillstand, ist nicht zu erkennen.</translation>
    </message>
    <message>
        <source>{} patches on {} parts that turned against each other.</source>
        <translation>{} Hautstücke auf {} Teilen, die sich gegeneinander gedreht haben.</translation>
    </message>
    <message>
        <source>{} patches on up to {} parts: of {} of the {} pairs of parts these poses can&apos;t tell whether they move together.</source>
        <translation>{} Hautstücke auf bis zu {} Teilen: Bei {} der {} Paare von Teilen lassen diese Posen offen, ob sie sich gemeinsam bewegen.</translation>
    </message>
    <message>
        <source>false_alarm must be between 0 and 1</source>
        <translation>false_alarm muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>least_odds must be at least 1</source>
        <translation>least_odds muss mindestens 1 sein</translation>
    </message>
    <message>
        <source>lever_m must not be negative</source>
        <translation>lever_m darf nicht negativ sein</translation>
    </message>
    <message>
        <source>joint_lever_m must not be negative</source>
        <translation>joint_lever_m darf nicht negativ sein</translation>
    </message>
    <message>
        <source>most_poses must be at least 2</source>
        <translation>most_poses muss mindestens 2 sein</translation>
    </message>
    <message>
        <source>most_patches must be at least 1</source>
        <translation>most_patches muss mindestens 1 sein</translation>
    </message>
    <message>
        <source>The joint angles are probably degrees that were read as rad: as degrees they fit what the patches see, as rad they don&apos;t.</source>
        <translation>Die Gelenkwinkel sind wahrscheinlich Grad, die als rad gelesen wurden: Als Grad passen sie zu dem, was die Hautstücke sehen, als rad nicht.</translation>
    </message>
    <message>
        <source>The joint angles are probably rad that were read as degrees: as rad they fit what the patches see, as degrees they don&apos;t.</source>
        <translation>Die Gelenkwinkel sind wahrscheinlich rad, die als Grad gelesen wurden: Als rad passen sie zu dem, was die Hautstücke sehen, als Grad nicht.</translation>
    </message>
    <message>
        <source>Pose {} doesn&apos;t go with the others: without it every patch fits a link. Its joint angles are probably those of another moment.</source>
        <translation>Pose {} passt nicht zu den anderen: Ohne sie passt jedes Hautstück auf ein Glied. Ihre Gelenkwinkel sind wahrscheinlich die eines anderen Augenblicks.</translation>
    </message>
    <message>
        <source>Joint {} seems to count its angle the other way round: with its sign turned the angles fit what the patches see.</source>
        <translation>Gelenk {} scheint seinen Winkel andersherum zu zählen: Mit umgekehrtem Vorzeichen passen die Winkel zu dem, was die Hautstücke sehen.</translation>
    </message>
    <message>
        <source>One of the joints {} seems to count its angle the other way round: with its sign turned the angles fit what the patches see.</source>
        <translation>Eines der Gelenke {} scheint seinen Winkel andersherum zu zählen: Mit umgekehrtem Vorzeichen passen die Winkel zu dem, was die Hautstücke sehen.</translation>
    </message>
    <message>
        <source>The zero of joint {} seems to be off by about {}: if so much is added to its angle, the angles fit what the patches see.</source>
        <translation>Der Nullpunkt von Gelenk {} scheint um etwa {} verschoben zu sein: Wird so viel zu seinem Winkel addiert, passen die Winkel zu dem, was die Hautstücke sehen.</translation>
    </message>
    <message>
        <source>On which link a patch is can be told of a session that was just solved by the global solver, not of a calibration file or of the tree: they don&apos;t hold how well gravity is known.</source>
        <translation>Auf welchem Glied ein Hautstück sitzt, lässt sich nur von einer Sitzung sagen, die der globale Löser gerade gelöst hat, nicht von einer Kalibrierdatei oder vom Baum: Sie enthalten nicht, wie genau die Schwerkraft bekannt ist.</translation>
    </message>
    <message>
        <source>No joint angles are known of these poses, which are not compared: {}.</source>
        <translation>Von diesen Posen sind keine Gelenkwinkel bekannt; sie werden nicht verglichen: {}.</translation>
    </message>
    <message>
        <source>The angles of these joints are not known, and links beyond them are not compared: {}.</source>
        <translation>Die Winkel dieser Gelenke sind nicht bekannt, und Glieder jenseits von ihnen werden nicht verglichen: {}.</translation>
    </message>
    <message>
        <source>Pose {} is not compared, because it lacks the angles of these joints: {}.</source>
        <translation>Pose {} wird nicht verglichen, weil ihr die Winkel dieser Gelenke fehlen: {}.</translation>
    </message>
    <message>
        <source>There is no cell {} to put on link {}.</source>
        <translation>Es gibt keine Zelle {}, die auf Glied {} gesetzt werden könnte.</translation>
    </message>
    <message>
        <source>Cell {} can&apos;t be put on link {}: the angle of a joint that carries it is not known.</source>
        <translation>Zelle {} kann nicht auf Glied {} gesetzt werden: Der Winkel eines Gelenks, das es trägt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The patch of cell {} can&apos;t be on two links, {} and {}.</source>
        <translation>Das Hautstück von Zelle {} kann nicht auf zwei Gliedern sitzen, {} und {}.</translation>
    </message>
    <message>
        <source>How it is turned there about one axis is not determined: gravity came along one line in all poses.</source>
        <translation>Wie es dort um eine Achse gedreht ist, ist nicht bestimmt: Die Schwerkraft kam in allen Posen entlang einer Linie.</translation>
    </message>
    <message>
        <source>No joint moves link {}: only tipping the whole robot over would show it.</source>
        <translation>Kein Gelenk bewegt Glied {}: Nur wenn der ganze Roboter gekippt würde, zeigte es sich.</translation>
    </message>
    <message>
        <source>Take poses in which link {} is tipped over by about 90 degrees.</source>
        <translation>Nehmen Sie Posen auf, in denen Glied {} um etwa 90 Grad gekippt ist.</translation>
    </message>
    <message>
        <source>The patch of cell {} was put on link {}, which doesn&apos;t fit: what the patch saw of gravity is not what that link would see.</source>
        <translation>Das Hautstück von Zelle {} wurde auf Glied {} gesetzt, das nicht passt: Was das Hautstück von der Schwerkraft sah, ist nicht, was dieses Glied sähe.</translation>
    </message>
    <message>
        <source>The patch of cell {} was put on link {}, the only one that fits.</source>
        <translation>Das Hautstück von Zelle {} wurde auf Glied {} gesetzt, das einzige, das passt.</translation>
    </message>
    <message>
        <source>The patch of cell {} was put on link {}, which fits.</source>
        <translation>Das Hautstück von Zelle {} wurde auf Glied {} gesetzt, das passt.</translation>
    </message>
    <message>
        <source>The patch of cell {} fits no link: link {} comes nearest, with a chi-squared of {} at {} degrees of freedom.</source>
        <translation>Das Hautstück von Zelle {} passt auf kein Glied: Am nächsten kommt Glied {}, mit einem Chi-Quadrat von {} bei {} Freiheitsgraden.</translation>
    </message>
    <message>
        <source>On which link the patch of cell {} is can&apos;t be told from one pose, which any link fits.</source>
        <translation>Auf welchem Glied das Hautstück von Zelle {} sitzt, lässt sich aus einer einzigen Pose nicht sagen: Zu ihr passt jedes Glied.</translation>
    </message>
    <message>
        <source>The patch of cell {} fits several links, the best first: {}.</source>
        <translation>Das Hautstück von Zelle {} passt auf mehrere Glieder, das beste zuerst: {}.</translation>
    </message>
    <message>
        <source>The patch of cell {} is on link {}: no other link fits.</source>
        <translation>Das Hautstück von Zelle {} sitzt auf Glied {}: Kein anderes Glied passt.</translation>
    </message>
    <message>
        <source>The patch of cell {} is on one of these links, which turn as one: {}.</source>
        <translation>Das Hautstück von Zelle {} sitzt auf einem dieser Glieder, die sich nur gemeinsam drehen: {}.</translation>
    </message>
    <message>
        <source>The patch of cell {} is on one of these links, which these poses can&apos;t tell apart: {}.</source>
        <translation>Das Hautstück von Zelle {} sitzt auf einem dieser Glieder, die sich durch diese Posen nicht unterscheiden lassen: {}.</translation>
    </message>
    <message>
        <source>Take more poses, in which the joints that carry these links stand in other angles and the links in new directions.</source>
        <translation>Nehmen Sie weitere Posen auf, in denen die Gelenke, die diese Glieder tragen, in anderen Winkeln stehen und die Glieder in neuen Richtungen.</translation>
    </message>
    <message>
        <source>Move these joints by 30 degrees or more from pose to pose, with their axes level: {}.</source>
        <translation>Bewegen Sie diese Gelenke von Pose zu Pose um 30 Grad oder mehr, mit waagrechten Achsen: {}.</translation>
    </message>
    <message>
        <source>The zero of joint {} seems to be off: {} has to be added to the angle that it reports (1 sigma: {}).</source>
        <translation>Der Nullpunkt von Gelenk {} scheint verschoben zu sein: Zu dem Winkel, den es meldet, ist {} zu addieren (1 Sigma: {}).</translation>
    </message>
    <message>
        <source>The robot&apos;s base seems to be tilted by {} (1 sigma: {}).</source>
        <translation>Die Basis des Roboters scheint um {} geneigt zu sein (1 Sigma: {}).</translation>
    </message>
    <message>
        <source>Taken together, the patches fit the joint angles badly: a chi-squared of {} at {} degrees of freedom.</source>
        <translation>Zusammengenommen passen die Hautstücke schlecht zu den Gelenkwinkeln: ein Chi-Quadrat von {} bei {} Freiheitsgraden.</translation>
    </message>
    <message>
        <source>No pose has joint angles: on which links the patches are can&apos;t be told.</source>
        <translation>Keine Pose hat Gelenkwinkel: Auf welchen Gliedern die Hautstücke sitzen, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>No pose has both readings and the angles of the joints: on which links the patches are can&apos;t be told.</source>
        <translation>Keine Pose hat sowohl Messwerte als auch die Winkel der Gelenke: Auf welchen Gliedern die Hautstücke sitzen, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>Each of {} patches is on a link that is known.</source>
        <translation>Von jedem der {} Hautstücke ist bekannt, auf welchem Glied es sitzt.</translation>
    </message>
    <message>
        <source>Of {} patches {} are on a link that is known; of {} these poses leave open which it is, and {} fit none.</source>
        <translation>Von {} Hautstücken ist bei {} das Glied bekannt; bei {} lassen diese Posen offen, welches es ist, und {} passen auf keines.</translation>
    </message>
    <message>
        <source>up_w must be a direction</source>
        <translation>up_w muss eine Richtung sein</translation>
    </message>
    <message>
        <source>zero_sigma_rad must be above 0 and at most pi</source>
        <translation>zero_sigma_rad muss größer als 0 und höchstens pi sein</translation>
    </message>
    <message>
        <source>tilt_sigma_rad must be from 0 to pi</source>
        <translation>tilt_sigma_rad muss zwischen 0 und pi liegen</translation>
    </message>
    <message>
        <source>test_lever_m must not be negative</source>
        <translation>test_lever_m darf nicht negativ sein</translation>
    </message>
    <message>
        <source>The robot&apos;s base seems to stand otherwise than was said: the patches fit with {} of its frame upwards.</source>
        <translation>Die Basis des Roboters scheint anders zu stehen als angegeben: Die Hautstücke passen, wenn {} ihres Koordinatensystems nach oben zeigt.</translation>
    </message>
    <message>
        <source>The joint angles are probably off by one pose: with those of the pose after it, each pose fits what the patches see.</source>
        <translation>Die Gelenkwinkel sind wahrscheinlich um eine Pose verschoben: Mit denen der Pose danach passt jede Pose zu dem, was die Hautstücke sehen.</translation>
    </message>
    <message>
        <source>The joint angles are probably off by one pose: with those of the pose before it, each pose fits what the patches see.</source>
        <translation>Die Gelenkwinkel sind wahrscheinlich um eine Pose verschoben: Mit denen der Pose davor passt jede Pose zu dem, was die Hautstücke sehen.</translation>
    </message>
    <message>
        <source>the name of a link</source>
        <translation>der Name eines Glieds</translation>
    </message>
    <message>
        <source>each patch once; that of cell {} is there twice</source>
        <translation>jedes Hautstück einmal; das von Zelle {} steht zweimal da</translation>
    </message>
    <message>
        <source>slide along {}</source>
        <translation>verschoben werden, längs {}</translation>
    </message>
    <message>
        <source>slide and turn at once, as a screw about {}</source>
        <translation>zugleich verschoben und gedreht werden, wie eine Schraube längs {}</translation>
    </message>
    <message>
        <source>turn on the spot, about {}</source>
        <translation>auf der Stelle gedreht werden, um eine Achse längs {}</translation>
    </message>
    <message>
        <source>turn around an axis along {}, {} from its middle</source>
        <translation>um eine Achse längs {} gedreht werden, {} von seiner Mitte entfernt</translation>
    </message>
    <message>
        <source>Nothing but its known rotation keeps it from being free to {}: to {} (1 sigma).</source>
        <translation>Nur seine bekannte Drehung legt fest, wie weit es kann: {}; auf {} (1 Sigma).</translation>
    </message>
    <message>
        <source>It is free to {}, all the way round.</source>
        <translation>Es kann frei {}, ganz herum.</translation>
    </message>
    <message>
        <source>It is free to {}, by {} one way and {} the other.</source>
        <translation>Es kann frei {}, um {} in der einen und {} in der anderen Richtung.</translation>
    </message>
    <message>
        <source>It is free to {}, by {} forwards and {} backwards.</source>
        <translation>Es kann frei {}, um {} vorwärts und {} rückwärts.</translation>
    </message>
    <message>
        <source>the link&apos;s {} axis</source>
        <translation>der {}-Achse des Glieds</translation>
    </message>
    <message>
        <source>the direction ({}, {}, {}) of the link</source>
        <translation>der Richtung ({}, {}, {}) des Glieds</translation>
    </message>
    <message>
        <source>none of the patches to place holds a cell {}</source>
        <translation>keines der Hautstücke, deren Lage gesucht ist, enthält eine Zelle {}</translation>
    </message>
    <message>
        <source>the patch of cell {} needs a covariance of {} x {}, found {} numbers</source>
        <translation>das Hautstück von Zelle {} braucht eine Kovarianz von {} x {}, gefunden wurden {} Zahlen</translation>
    </message>
    <message>
        <source>the covariance of the patch of cell {} is none: it must be symmetric and positive semidefinite</source>
        <translation>die Kovarianz des Hautstücks von Zelle {} ist keine: sie muss symmetrisch und positiv semidefinit sein</translation>
    </message>
    <message>
        <source>the patch of cell {} must hold that cell, and a placement of every cell</source>
        <translation>das Hautstück von Zelle {} muss diese Zelle enthalten, und von jeder Zelle die Lage</translation>
    </message>
    <message>
        <source>the rotation of the patch of cell {} must be a rotation with a positive definite covariance</source>
        <translation>die Drehung des Hautstücks von Zelle {} muss eine Drehung mit positiv definiter Kovarianz sein</translation>
    </message>
    <message>
        <source>a placement in the patch of cell {} is not finite</source>
        <translation>eine Lage im Hautstück von Zelle {} ist nicht endlich</translation>
    </message>
    <message>
        <source>there is no patch to place</source>
        <translation>es gibt kein Hautstück, dessen Lage zu suchen wäre</translation>
    </message>
    <message>
        <source>nothing says where on the link the patch lies: it takes the link&apos;s surface, or points, or distances to another patch</source>
        <translation>nichts sagt, wo am Glied das Hautstück liegt: es braucht die Oberfläche des Glieds, oder Punkte, oder Abstände zu einem anderen Hautstück</translation>
    </message>
    <message>
        <source>How certain the cells of the patch of cell {} are is not stated; 2 mm and 3° were taken for each.</source>
        <translation>Wie sicher die Zellen des Hautstücks von Zelle {} sind, ist nicht angegeben; für jede wurden 2 mm und 3° angenommen.</translation>
    </message>
    <message>
        <source>{} places fit; the best {} are given.</source>
        <translation>{} Lagen passen; die besten {} sind angegeben.</translation>
    </message>
    <message>
        <source>the mesh of link {} holds points that are not finite</source>
        <translation>das Netz von Glied {} enthält Punkte, die nicht endlich sind</translation>
    </message>
    <message>
        <source>The mesh of link {} is inside out: its triangles are clockwise as seen from outside, and the volume inside is negative. It was taken the other way round.</source>
        <translation>Das Netz von Glied {} ist umgestülpt: seine Dreiecke laufen von außen gesehen im Uhrzeigersinn, und das Volumen darin ist negativ. Es wurde andersherum genommen.</translation>
    </message>
    <message>
        <source>the mesh of link {} has no triangle with an area, on which a patch could lie</source>
        <translation>das Netz von Glied {} hat kein Dreieck mit einer Fläche, auf der ein Hautstück liegen könnte</translation>
    </message>
    <message>
        <source>cell {} is there twice</source>
        <translation>Zelle {} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the sigma of the point of cell {}</source>
        <translation>das Sigma des Punkts von Zelle {}</translation>
    </message>
    <message>
        <source>cells {} and {} are of one patch: their distance says nothing of its place</source>
        <translation>die Zellen {} und {} gehören zu einem Hautstück: ihr Abstand sagt nichts über dessen Lage</translation>
    </message>
    <message>
        <source>the distance between cells {} and {}</source>
        <translation>der Abstand zwischen den Zellen {} und {}</translation>
    </message>
    <message>
        <source>the sigma of the distance between cells {} and {}</source>
        <translation>das Sigma des Abstands zwischen den Zellen {} und {}</translation>
    </message>
    <message>
        <source>The patch of cell {} is larger than link {}: {} from cell to cell, where the link&apos;s box measures {} from corner to corner. It belongs on another link, or the mesh is not in metres.</source>
        <translation>Das Hautstück von Zelle {} ist größer als Glied {}: {} von Zelle zu Zelle, während der Kasten um das Glied {} von Ecke zu Ecke misst. Es gehört an ein anderes Glied, oder das Netz ist nicht in Metern.</translation>
    </message>
    <message>
        <source>The patch of cell {}</source>
        <translation>Das Hautstück von Zelle {}</translation>
    </message>
    <message>
        <source>The patches of cells {}</source>
        <translation>Die Hautstücke der Zellen {}</translation>
    </message>
    <message>
        <source>{}: nowhere on link {} does the surface face as it would have to. Is it the right link, and is the rotation right?</source>
        <translation>{}: nirgends an Glied {} zeigt die Oberfläche dorthin, wohin sie müsste. Ist es das richtige Glied, und stimmt die Drehung?</translation>
    </message>
    <message>
        <source>{}: no place on link {} fits. At the best one the misfit is {} rms, chi-squared {} with {} degrees of freedom. Is it the right link, are all lengths in metres, and do the cells lie on the surface that the mesh describes?</source>
        <translation>{}: keine Lage an Glied {} passt. Die beste weicht um {} ab (quadratisches Mittel), Chi-Quadrat {} bei {} Freiheitsgraden. Ist es das richtige Glied, sind alle Längen in Metern, und liegen die Zellen auf der Oberfläche, die das Netz beschreibt?</translation>
    </message>
    <message>
        <source>{}: {} places on link {} fit. A point whose place on the link is known would tell them apart.</source>
        <translation>{}: {} Lagen an Glied {} passen. Ein Punkt, dessen Ort am Glied bekannt ist, würde sie unterscheiden.</translation>
    </message>
    <message>
        <source>{}: one place on link {} fits, certain to {} (95 %, the worst cell).</source>
        <translation>{}: eine Lage an Glied {} passt, auf {} sicher (95 %, die schlechteste Zelle).</translation>
    </message>
    <message>
        <source>{}: one place on link {} fits, but not all of it is determined.</source>
        <translation>{}: eine Lage an Glied {} passt, aber sie ist nicht ganz bestimmt.</translation>
    </message>
    <message>
        <source>Cell {}&apos;s patch: {}</source>
        <translation>Hautstück von Zelle {}: {}</translation>
    </message>
    <message>
        <source>the sigma of the surface</source>
        <translation>das Sigma der Oberfläche</translation>
    </message>
    <message>
        <source>the length beyond which a direction is free</source>
        <translation>die Länge, ab der eine Richtung frei ist</translation>
    </message>
    <message>
        <source>the probability of a false alarm must be between 0 and 1</source>
        <translation>die Wahrscheinlichkeit eines Fehlalarms muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>there must be room for at least one candidate</source>
        <translation>es muss Platz für mindestens einen Kandidaten sein</translation>
    </message>
    <message>
        <source>the origin cell of a patch</source>
        <translation>die Ursprungszelle eines Hautstücks</translation>
    </message>
    <message>
        <source>No patch fits any link: perhaps the robot&apos;s base did not stand still in all poses, or joint angles and URDF are those of another robot.</source>
        <translation>Kein Hautstück passt auf irgendein Glied: Vielleicht stand die Basis des Roboters nicht in allen Posen still, oder Gelenkwinkel und URDF sind die eines anderen Roboters.</translation>
    </message>
    <message>
        <source>kind: expected capture, remove, restore, disable, enable, joints, mute, unmute, robot, placement, skin, source, truth or options, found &quot;{}&quot;</source>
        <translation>kind: erwartet capture, remove, restore, disable, enable, joints, mute, unmute, robot, placement, skin, source, truth oder options, gefunden „{}“</translation>
    </message>
    <message>
        <source>the patch of cell {}</source>
        <translation>das Hautstück von Zelle {}</translation>
    </message>
    <message>
        <source>the description of a robot needs a file</source>
        <translation>die Beschreibung eines Roboters braucht eine Datei</translation>
    </message>
    <message>
        <source>a package has a name and a folder</source>
        <translation>ein Paket hat einen Namen und einen Ordner</translation>
    </message>
    <message>
        <source>expected a point within {} m and a sigma above 0 for cell {}</source>
        <translation>erwartet einen Punkt innerhalb von {} m und ein Sigma über 0 für Zelle {}</translation>
    </message>
    <message>
        <source>expected a distance above 0 between two cells, and a sigma above 0, for cell {}</source>
        <translation>erwartet einen Abstand über 0 zwischen zwei Zellen und ein Sigma über 0 für Zelle {}</translation>
    </message>
    <message>
        <source>expected a place of this patch on its link</source>
        <translation>erwartet einen Platz dieses Hautstücks auf seinem Glied</translation>
    </message>
    <message>
        <source>expected a rotation and a translation within {} m</source>
        <translation>erwartet eine Drehung und eine Verschiebung innerhalb von {} m</translation>
    </message>
    <message>
        <source>expected a covariance (positive semidefinite)</source>
        <translation>erwartet eine Kovarianz (positiv semidefinit)</translation>
    </message>
    <message>
        <source>the name of a file</source>
        <translation>der Name einer Datei</translation>
    </message>
    <message>
        <source>a name and a folder</source>
        <translation>ein Name und ein Ordner</translation>
    </message>
    <message>
        <source>each package once</source>
        <translation>jedes Paket einmal</translation>
    </message>
    <message>
        <source>a placement that makes sense ({})</source>
        <translation>eine sinnvolle Einordnung ({})</translation>
    </message>
    <message>
        <source>See that the cells send readings, and that the calibration was made of three poses or more.</source>
        <translation>Prüfen, ob die Zellen Messwerte senden und ob die Kalibrierung aus mindestens drei Posen stammt.</translation>
    </message>
    <message>
        <source>As far as it could be compared, the calibration still holds.</source>
        <translation>Soweit sie sich vergleichen ließ, gilt die Kalibrierung noch.</translation>
    </message>
    <message>
        <source>The calibration still holds: it can be used as before.</source>
        <translation>Die Kalibrierung gilt noch und lässt sich weiter verwenden.</translation>
    </message>
    <message>
        <source>A cell that turned came loose or was fixed anew: see that it sits firmly, then calibrate anew.</source>
        <translation>Eine gedrehte Zelle hat sich gelöst oder wurde neu befestigt: dafür sorgen, dass sie fest sitzt, dann neu kalibrieren.</translation>
    </message>
    <message>
        <source>A cell whose offset drifted is still where it was; its readings are off by that much until the skin is calibrated anew.</source>
        <translation>Eine Zelle, deren Offset gedriftet ist, sitzt noch, wo sie war; ihre Messwerte sind um so viel falsch, bis die Haut neu kalibriert ist.</translation>
    </message>
    <message>
        <source>Another pose, with the part turned by 45° or more, tells a turn from a drift.</source>
        <translation>Eine weitere Pose, mit dem Körperteil um mindestens 45° gedreht, unterscheidet eine Drehung von einer Drift.</translation>
    </message>
    <message>
        <source>Check the sensor, plug and cable of a cell that is dead, broken or gone.</source>
        <translation>Bei einer Zelle, die tot, defekt oder verschwunden ist, Sensor, Stecker und Kabel prüfen.</translation>
    </message>
    <message>
        <source>What neither a turn nor a drift explains may have happened between these poses: compare only those that were taken since.</source>
        <translation>Was weder eine Drehung noch eine Drift erklärt, kann zwischen diesen Posen geschehen sein: nur mit denen vergleichen, die danach aufgenommen wurden.</translation>
    </message>
    <message>
        <source>See that the cells are still joined where a link is no longer reported.</source>
        <translation>Prüfen, ob die Zellen noch verbunden sind, wo eine Verbindung nicht mehr gemeldet wird.</translation>
    </message>
    <message>
        <source>Here the patch is turned by {} against what gravity says, which is certain to {} (1 sigma).</source>
        <translation>Hier ist das Hautstück um {} anders gedreht, als die Schwerkraft sagt, die es auf {} genau angibt (1 Sigma).</translation>
    </message>
    <message>
        <source>the place at which the patch of cell {} was put is none</source>
        <translation>der Platz, an den das Hautstück von Zelle {} gelegt wurde, ist keiner</translation>
    </message>
    <message>
        <source>Where the patch of cell {} was put by hand, it is turned by {} against what gravity says, which is certain to {} (1 sigma); the fit moved it by {}.</source>
        <translation>Wo das Hautstück von Zelle {} von Hand hingelegt wurde, ist es um {} anders gedreht, als die Schwerkraft sagt, die es auf {} genau angibt (1 Sigma); die Anpassung hat es um {} bewegt.</translation>
    </message>
    <message>
        <source>the names and angles of {} joints take {} bytes, and a message on this wire has {}</source>
        <translation>die Namen und Winkel von {} Gelenken brauchen {} Bytes, eine Nachricht auf dieser Leitung hat {}</translation>
    </message>
    <message>
        <source>mount: expected {}, found &quot;{}&quot;</source>
        <translation>mount: erwartet ist {}, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>base: expected fixed, motors or hand, found &quot;{}&quot;</source>
        <translation>base: erwartet ist fixed, motors oder hand, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>base: a robot with its motors on is not ideal</source>
        <translation>base: Ein Roboter mit eingeschalteten Motoren ist nicht ideal</translation>
    </message>
    <message>
        <source>the robot needs a mount for each patch, {}</source>
        <translation>der Roboter braucht für jeden Patch ein mount, {}</translation>
    </message>
    <message>
        <source>there is no cell {}; cells are 1 to {}</source>
        <translation>es gibt keine Zelle {}; die Zellen sind 1 bis {}</translation>
    </message>
    <message>
        <source>patch on {}, whose cell 1 is the robot&apos;s cell {}</source>
        <translation>Patch auf {}, dessen Zelle 1 die Zelle {} des Roboters ist</translation>
    </message>
    <message>
        <source>the joints can&apos;t turn cell {} there: they come within {}</source>
        <translation>die Gelenke können Zelle {} nicht dorthin drehen: Sie kommen nur bis auf {} heran</translation>
    </message>
    <message>
        <source>the robot&apos;s base is fixed: only its joints turn</source>
        <translation>die Basis des Roboters steht fest: Nur seine Gelenke drehen sich</translation>
    </message>
    <message>
        <source>source &quot;{}&quot;: expected sim:robot[?urdf=FILE&amp;package=NAME=FOLDER&amp;mount=LINK:X,Y,Z&amp;base=fixed|motors|hand&amp;patch=...&amp;surface=...&amp;seed=N&amp;speed=X|max], found &quot;{}&quot;</source>
        <translation>Quelle „{}“: erwartet ist sim:robot[?urdf=DATEI&amp;package=NAME=ORDNER&amp;mount=GLIED:X,Y,Z&amp;base=fixed|motors|hand&amp;patch=...&amp;surface=...&amp;seed=N&amp;speed=X|max], gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>package: expected NAME=FOLDER, found &quot;{}&quot;</source>
        <translation>package: erwartet ist NAME=ORDNER, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>Good: {}, {}.</source>
        <translation>Gut: {}, {}.</translation>
    </message>
    <message>
        <source>Usable: {}, {}.</source>
        <translation>Brauchbar: {}, {}.</translation>
    </message>
    <message>
        <source>Not enough: {}, {}.</source>
        <translation>Nicht genug: {}, {}.</translation>
    </message>
    <message>
        <source>{} (95 %)</source>
        <translation>{} (95 %)</translation>
    </message>
    <message>
        <source>{} (95 %, worst: {})</source>
        <translation>{} (95 %, am schlechtesten: {})</translation>
    </message>
    <message>
        <source>{} (95 %, worst measured: {})</source>
        <translation>{} (95 %, am schlechtesten von den gemessenen: {})</translation>
    </message>
    <message>
        <source>The device&apos;s list names one ID twice, and two cells can&apos;t share an ID.</source>
        <translation>Die Liste des Geräts nennt eine ID zweimal, und zwei Zellen können keine ID gemeinsam haben.</translation>
    </message>
    <message>
        <source>Give one of the two cells another ID, and connect again.</source>
        <translation>Einer der beiden Zellen eine andere ID geben und neu verbinden.</translation>
    </message>
    <message>
        <source>ID 0 stands for nothing, and the interface&apos;s ID for the computer: a cell with such an ID can&apos;t be told from them.</source>
        <translation>Die ID 0 steht für nichts und die des Interface für den Rechner: Eine Zelle mit einer solchen ID lässt sich davon nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Give the cell another ID, and connect again.</source>
        <translation>Der Zelle eine andere ID geben und neu verbinden.</translation>
    </message>
    <message>
        <source>The port that was reported is not among those of the cell model.</source>
        <translation>Der gemeldete Port gehört nicht zu denen des Zellmodells.</translation>
    </message>
    <message>
        <source>Check that the cell model is that of this skin. If it is, the report of the cell is wrong: connect again.</source>
        <translation>Prüfen, ob das Zellmodell das dieser Haut ist. Wenn ja, ist die Meldung der Zelle falsch: neu verbinden.</translation>
    </message>
    <message>
        <source>A cell reports a neighbour that did not report itself: it has no power, or its report was lost.</source>
        <translation>Eine Zelle meldet einen Nachbarn, der sich selbst nicht gemeldet hat: Er hat keinen Strom, oder seine Meldung ging verloren.</translation>
    </message>
    <message>
        <source>Check the power and the contacts of the missing cell, and connect again.</source>
        <translation>Stromversorgung und Kontakte der fehlenden Zelle prüfen und neu verbinden.</translation>
    </message>
    <message>
        <source>A link joins two cells. One that ends where it begins comes from a short circuit or a wrong report.</source>
        <translation>Eine Verbindung hat zwei Zellen. Eine, die endet, wo sie beginnt, kommt von einem Kurzschluss oder einer falschen Meldung.</translation>
    </message>
    <message>
        <source>Check the ports of this cell, and connect again.</source>
        <translation>Die Ports dieser Zelle prüfen und neu verbinden.</translation>
    </message>
    <message>
        <source>A sound link is seen from both of its ends, and here one end sees nothing: a contact is loose, or a report was lost.</source>
        <translation>Eine heile Verbindung ist von beiden Enden zu sehen, und hier sieht ein Ende nichts: Ein Kontakt ist lose, oder eine Meldung ging verloren.</translation>
    </message>
    <message>
        <source>Check the contacts between the two cells, and connect again. If nothing joins them there, leave it as it is.</source>
        <translation>Die Kontakte zwischen den beiden Zellen prüfen und neu verbinden. Wenn sie dort nichts verbindet, kann es so bleiben.</translation>
    </message>
    <message>
        <source>The two cells name different ports, or different neighbours, for what should be one link.</source>
        <translation>Die beiden Zellen nennen verschiedene Ports oder verschiedene Nachbarn für das, was eine Verbindung sein sollte.</translation>
    </message>
    <message>
        <source>Check how the two cells are joined, and connect again.</source>
        <translation>Prüfen, wie die beiden Zellen verbunden sind, und neu verbinden.</translation>
    </message>
    <message>
        <source>A port leads to one neighbour at most, and two cells are joined once at most.</source>
        <translation>Ein Port führt zu höchstens einem Nachbarn, und zwei Zellen sind höchstens einmal verbunden.</translation>
    </message>
    <message>
        <source>Check the ports that are named for a short circuit or a wrong cable, and connect again.</source>
        <translation>Die genannten Ports auf einen Kurzschluss oder ein falsches Kabel prüfen und neu verbinden.</translation>
    </message>
    <message>
        <source>Cells side by side in the mould can&apos;t touch with these two ports.</source>
        <translation>Zellen, die in der Form nebeneinanderliegen, können sich mit diesen beiden Ports nicht berühren.</translation>
    </message>
    <message>
        <source>If a cable joins the two cells, leave it as it is. If not, check the cell model.</source>
        <translation>Wenn ein Kabel die beiden Zellen verbindet, kann es so bleiben. Wenn nicht, das Zellmodell prüfen.</translation>
    </message>
    <message>
        <source>The computer&apos;s interface is at this port, and it is no cell.</source>
        <translation>An diesem Port ist das Interface des Rechners, und das ist keine Zelle.</translation>
    </message>
    <message>
        <source>Nothing: this is as it should be.</source>
        <translation>Nichts: So soll es sein.</translation>
    </message>
    <message>
        <source>Body parts move against each other, so a link between them is not rigid.</source>
        <translation>Körperteile bewegen sich gegeneinander, daher ist eine Verbindung zwischen ihnen nicht starr.</translation>
    </message>
    <message>
        <source>Nothing, if the names of the body parts are right.</source>
        <translation>Nichts, wenn die Namen der Körperteile stimmen.</translation>
    </message>
    <message>
        <source>Gravity, as the two cells feel it, says that they stand at a steeper angle than the mould lets them.</source>
        <translation>Die Schwerkraft, wie die beiden Zellen sie spüren, sagt, dass sie steiler zueinander stehen, als die Form es zulässt.</translation>
    </message>
    <message>
        <source>Look at the two cells. If a cable joins them, or a joint lies between them, set the link aside. If they lie side by side in the mould, check the axes of their sensors.</source>
        <translation>Die beiden Zellen ansehen. Wenn ein Kabel sie verbindet oder ein Gelenk zwischen ihnen liegt, die Verbindung ausschließen. Wenn sie in der Form nebeneinanderliegen, die Achsen ihrer Sensoren prüfen.</translation>
    </message>
    <message>
        <source>Gravity, as the two cells feel it, says that they are twisted about the line between them further than the mould lets them.</source>
        <translation>Die Schwerkraft, wie die beiden Zellen sie spüren, sagt, dass sie um die Linie zwischen ihnen weiter verdreht sind, als die Form es zulässt.</translation>
    </message>
    <message>
        <source>Look at the two cells. If a cable joins them, or other ports than those that are named, set the link aside. If not, check the axes of their sensors.</source>
        <translation>Die beiden Zellen ansehen. Wenn ein Kabel oder andere als die genannten Ports sie verbinden, die Verbindung ausschließen. Wenn nicht, die Achsen ihrer Sensoren prüfen.</translation>
    </message>
    <message>
        <source>Gravity, as the two cells feel it, says that they are turned against each other in the surface further than the mould lets them.</source>
        <translation>Die Schwerkraft, wie die beiden Zellen sie spüren, sagt, dass sie in der Fläche weiter gegeneinander gedreht sind, als die Form es zulässt.</translation>
    </message>
    <message>
        <source>The angle between the two cells was another one from pose to pose, by more than their readings err.</source>
        <translation>Der Winkel zwischen den beiden Zellen war von Pose zu Pose ein anderer, um mehr, als ihre Messwerte fehlgehen.</translation>
    </message>
    <message>
        <source>If a joint lies between the two cells, set the link aside. If not, fix them in the mould and take the poses again.</source>
        <translation>Wenn ein Gelenk zwischen den beiden Zellen liegt, die Verbindung ausschließen. Wenn nicht, sie in der Form befestigen und die Posen neu aufnehmen.</translation>
    </message>
    <message>
        <source>Where all other links are followed, the two ends of this one should meet, and they do not.</source>
        <translation>Folgt man allen anderen Verbindungen, sollten die beiden Enden von dieser sich treffen, und das tun sie nicht.</translation>
    </message>
    <message>
        <source>Look at the links of this loop for a cable. Set that one aside; if this one is sound, take it back.</source>
        <translation>Unter den Verbindungen dieser Schleife ein Kabel suchen und ausschließen; ist diese hier heil, sie wieder zulassen.</translation>
    </message>
    <message>
        <source>Somebody set this link aside in this session.</source>
        <translation>Jemand hat diese Verbindung in dieser Sitzung ausgeschlossen.</translation>
    </message>
    <message>
        <source>Nothing. Take the link back if it should count again.</source>
        <translation>Nichts. Die Verbindung wieder zulassen, wenn sie wieder zählen soll.</translation>
    </message>
    <message>
        <source>A surface bends to either side. A twist to one side everywhere comes from a wrong description of the cell.</source>
        <translation>Eine Fläche krümmt sich nach beiden Seiten. Eine Verwindung überall zur selben Seite kommt von einer falschen Beschreibung der Zelle.</translation>
    </message>
    <message>
        <source>Compare the axes and the numbers of the ports in the cell model with a real cell.</source>
        <translation>Die Achsen und die Nummern der Ports im Zellmodell mit einer wirklichen Zelle vergleichen.</translation>
    </message>
    <message>
        <source>The cell sent no readings that can be used in any pose that counts.</source>
        <translation>Die Zelle hat in keiner Pose, die zählt, brauchbare Messwerte gesendet.</translation>
    </message>
    <message>
        <source>Check the power and the contacts of the cell, and take the poses again. It may stay as it is: it is less certain than the others then.</source>
        <translation>Stromversorgung und Kontakte der Zelle prüfen und die Posen neu aufnehmen. Es kann auch so bleiben: Dann ist sie weniger sicher als die anderen.</translation>
    </message>
    <message>
        <source>The cell sent no readings that can be used while these poses were captured.</source>
        <translation>Die Zelle hat keine brauchbaren Messwerte gesendet, während diese Posen aufgenommen wurden.</translation>
    </message>
    <message>
        <source>Nothing has to be done. With these poses taken again the cell is known better.</source>
        <translation>Es muss nichts geschehen. Werden diese Posen neu aufgenommen, ist die Zelle besser bekannt.</translation>
    </message>
    <message>
        <source>At rest a sensor reads 1 g along some direction, and this one reads nothing like it.</source>
        <translation>In Ruhe misst ein Sensor 1 g in irgendeiner Richtung, und dieser misst nichts dergleichen.</translation>
    </message>
    <message>
        <source>Replace the cell, or leave it as it is: it is less certain than the others then.</source>
        <translation>Die Zelle ersetzen oder so lassen: Dann ist sie weniger sicher als die anderen.</translation>
    </message>
    <message>
        <source>The part was turned from pose to pose, and what this sensor reads stayed the same.</source>
        <translation>Das Teil wurde von Pose zu Pose gedreht, und was dieser Sensor misst, blieb gleich.</translation>
    </message>
    <message>
        <source>At the end of its range a sensor can&apos;t tell how large a value is.</source>
        <translation>Am Ende seines Messbereichs kann ein Sensor nicht sagen, wie groß ein Wert ist.</translation>
    </message>
    <message>
        <source>Take the pose again without a jolt. If it happens again, check the range that the sensor is set to.</source>
        <translation>Die Pose ohne Stoß neu aufnehmen. Geschieht es wieder, den eingestellten Messbereich des Sensors prüfen.</translation>
    </message>
    <message>
        <source>The part was still, as the other cells show, and the readings of this one scatter.</source>
        <translation>Das Teil war ruhig, wie die anderen Zellen zeigen, und die Messwerte von dieser streuen.</translation>
    </message>
    <message>
        <source>Check that the cell sits firmly and that its power is steady, and take the poses again.</source>
        <translation>Prüfen, ob die Zelle fest sitzt und ihre Versorgung ruhig ist, und die Posen neu aufnehmen.</translation>
    </message>
    <message>
        <source>At rest a reading is 1 g long, whatever its direction.</source>
        <translation>In Ruhe ist ein Messwert 1 g lang, gleich in welcher Richtung.</translation>
    </message>
    <message>
        <source>Check the sensor of the cell, and the scale in which its readings are sent.</source>
        <translation>Den Sensor der Zelle prüfen und den Maßstab, in dem seine Messwerte gesendet werden.</translation>
    </message>
    <message>
        <source>From pose to pose two axes follow gravity, and the third does not.</source>
        <translation>Von Pose zu Pose folgen zwei Achsen der Schwerkraft, und die dritte nicht.</translation>
    </message>
    <message>
        <source>At rest a reading is 1 g long, and the readings of this cell are too long or too short in every pose.</source>
        <translation>In Ruhe ist ein Messwert 1 g lang, und die Messwerte dieser Zelle sind in jeder Pose zu lang oder zu kurz.</translation>
    </message>
    <message>
        <source>However the cell is placed in the patch, its readings contradict those of the others.</source>
        <translation>Wie auch immer die Zelle im Hautstück liegt, widersprechen ihre Messwerte denen der anderen.</translation>
    </message>
    <message>
        <source>Check that the cell is not loose, and that its axes are those of the cell model.</source>
        <translation>Prüfen, ob die Zelle nicht lose ist und ihre Achsen die des Zellmodells sind.</translation>
    </message>
    <message>
        <source>No two sensors read the same to the last bit: the readings of one cell were sent in the name of another.</source>
        <translation>Keine zwei Sensoren messen bis aufs letzte Bit dasselbe: Die Messwerte einer Zelle wurden im Namen einer anderen gesendet.</translation>
    </message>
    <message>
        <source>Check the IDs of these cells, and how their data are passed on.</source>
        <translation>Die IDs dieser Zellen prüfen und wie ihre Daten weitergegeben werden.</translation>
    </message>
    <message>
        <source>If the readings of the two cells are exchanged, they fit with those around them.</source>
        <translation>Vertauscht man die Messwerte der beiden Zellen, passen sie zu denen ringsum.</translation>
    </message>
    <message>
        <source>Exchange the IDs of the two cells, or check how their data are passed on.</source>
        <translation>Die IDs der beiden Zellen vertauschen oder prüfen, wie ihre Daten weitergegeben werden.</translation>
    </message>
    <message>
        <source>The readings fit as soon as the cell is taken to lie otherwise.</source>
        <translation>Die Messwerte passen, sobald man annimmt, dass die Zelle anders liegt.</translation>
    </message>
    <message>
        <source>Look how the cell lies in the mould, and whether its sensor sits as the cell model says.</source>
        <translation>Nachsehen, wie die Zelle in der Form liegt und ob ihr Sensor so sitzt, wie das Zellmodell sagt.</translation>
    </message>
    <message>
        <source>From one pose on the readings fit another orientation of the cell than before.</source>
        <translation>Von einer Pose an passen die Messwerte zu einer anderen Ausrichtung der Zelle als davor.</translation>
    </message>
    <message>
        <source>Fix the cell in the mould, and take the poses again.</source>
        <translation>Die Zelle in der Form befestigen und die Posen neu aufnehmen.</translation>
    </message>
    <message>
        <source>The readings fit worse than those of the other cells, and several causes would explain it.</source>
        <translation>Die Messwerte passen schlechter als die der anderen Zellen, und mehrere Ursachen würden es erklären.</translation>
    </message>
    <message>
        <source>Take another pose: it tells more about the cause.</source>
        <translation>Eine weitere Pose aufnehmen: Sie sagt mehr über die Ursache.</translation>
    </message>
    <message>
        <source>Freed from all that is known, the readings still differ by more than the cell model&apos;s sigmas explain.</source>
        <translation>Von allem Bekannten befreit, weichen die Messwerte immer noch mehr ab, als die Sigmas des Zellmodells erklären.</translation>
    </message>
    <message>
        <source>Find out the errors with hexoderm-cli sensors, and write them into the cell model.</source>
        <translation>Die Fehler mit hexoderm-cli sensors bestimmen und ins Zellmodell schreiben.</translation>
    </message>
    <message>
        <source>It was asked for when this result was solved.</source>
        <translation>Es wurde verlangt, als dieses Ergebnis berechnet wurde.</translation>
    </message>
    <message>
        <source>Nothing. Solve again with the cell if it should count.</source>
        <translation>Nichts. Noch einmal mit der Zelle rechnen, wenn sie zählen soll.</translation>
    </message>
    <message>
        <source>The pose was captured with other cells than the skin has, or an ID was misread.</source>
        <translation>Die Pose wurde mit anderen Zellen aufgenommen, als die Haut hat, oder eine ID wurde falsch gelesen.</translation>
    </message>
    <message>
        <source>Connect again, so that the list of cells is read anew, and take the pose again.</source>
        <translation>Neu verbinden, damit die Liste der Zellen neu gelesen wird, und die Pose neu aufnehmen.</translation>
    </message>
    <message>
        <source>A cell has one reading in a pose, and nothing says which of the two is right.</source>
        <translation>Eine Zelle hat in einer Pose einen Messwert, und nichts sagt, welcher der beiden der richtige ist.</translation>
    </message>
    <message>
        <source>Take the pose again if the cell does not fit.</source>
        <translation>Die Pose neu aufnehmen, wenn die Zelle nicht passt.</translation>
    </message>
    <message>
        <source>Every pose has an ID of its own; files that were joined can hold one twice.</source>
        <translation>Jede Pose hat eine eigene ID; Dateien, die zusammengefügt wurden, können eine zweimal enthalten.</translation>
    </message>
    <message>
        <source>Disable one of the two if they are the same.</source>
        <translation>Eine der beiden nicht benutzen, wenn sie gleich sind.</translation>
    </message>
    <message>
        <source>The ports say how cells lie beside each other in a plane. Only gravity tells how the surface bends.</source>
        <translation>Die Ports sagen, wie Zellen in einer Ebene nebeneinanderliegen. Erst die Schwerkraft sagt, wie die Fläche sich krümmt.</translation>
    </message>
    <message>
        <source>Hold the part still, and take a first pose.</source>
        <translation>Das Teil ruhig halten und eine erste Pose aufnehmen.</translation>
    </message>
    <message>
        <source>About a line along which gravity was always seen, a cell could be turned in any way.</source>
        <translation>Um eine Linie, entlang der die Schwerkraft immer zu sehen war, könnte eine Zelle beliebig gedreht sein.</translation>
    </message>
    <message>
        <source>Turn the part by about 90 degrees about a horizontal axis, and take a pose.</source>
        <translation>Das Teil um etwa 90 Grad um eine waagrechte Achse drehen und eine Pose aufnehmen.</translation>
    </message>
    <message>
        <source>Gravity along a line that was seen before tells nothing new about the shape.</source>
        <translation>Schwerkraft entlang einer Linie, die schon zu sehen war, sagt nichts Neues über die Form.</translation>
    </message>
    <message>
        <source>Nothing has to be done. Turn the part further before the next pose.</source>
        <translation>Es muss nichts geschehen. Das Teil vor der nächsten Pose weiter drehen.</translation>
    </message>
    <message>
        <source>While a part moves, its sensors feel the motion beside gravity.</source>
        <translation>Während ein Teil sich bewegt, spüren seine Sensoren neben der Schwerkraft die Bewegung.</translation>
    </message>
    <message>
        <source>Take the pose again and hold the part still, or disable it.</source>
        <translation>Die Pose neu aufnehmen und das Teil ruhig halten, oder sie nicht benutzen.</translation>
    </message>
    <message>
        <source>In the other poses the cells agree: in this one the part moved, or something pressed on the skin.</source>
        <translation>In den anderen Posen sind die Zellen sich einig: In dieser hat das Teil sich bewegt, oder etwas hat auf die Haut gedrückt.</translation>
    </message>
    <message>
        <source>Take the pose again and let nothing touch the skin, or disable it.</source>
        <translation>Die Pose neu aufnehmen und nichts die Haut berühren lassen, oder sie nicht benutzen.</translation>
    </message>
    <message>
        <source>The patch of cell {} is in its place on link {}.</source>
        <translation>Das Hautstück der Zelle {} ist an seinem Ort am Glied {}.</translation>
    </message>
    <message>
        <source>The patch of cell {} has its origin at link {}: its place on the robot is not known.</source>
        <translation>Das Hautstück der Zelle {} hat seinen Ursprung am Glied {}: Sein Ort am Roboter ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Coordinates are in the frame of link {}.</source>
        <translation>Koordinaten im Koordinatensystem des Glieds {}.</translation>
    </message>
    <message>
        <source>Coordinates of each patch are in the frame of its origin cell.</source>
        <translation>Koordinaten jedes Hautstücks im Koordinatensystem seiner Ursprungszelle.</translation>
    </message>
    <message>
        <source>Coordinates are in the frame of cell {}, the origin of the patch.</source>
        <translation>Koordinaten im Koordinatensystem der Zelle {}, des Ursprungs des Hautstücks.</translation>
    </message>
    <message>
        <source>Lengths are in millimetres.</source>
        <translation>Längen in Millimetern.</translation>
    </message>
    <message>
        <source>Lengths are in nanometres.</source>
        <translation>Längen in Nanometern.</translation>
    </message>
    <message>
        <source>Lengths are in metres.</source>
        <translation>Längen in Metern.</translation>
    </message>
    <message>
        <source>everything that is known, to be opened, compared and exported from again</source>
        <translation>alles, was bekannt ist, zum Öffnen, Vergleichen und erneuten Exportieren</translation>
    </message>
    <message>
        <source>Coordinates of each patch are in the frame of its origin cell. Lengths are in metres.</source>
        <translation>Koordinaten jedes Hautstücks im Koordinatensystem seiner Ursprungszelle. Längen in Metern.</translation>
    </message>
    <message>
        <source>what each file is, in which frame, with its hash, and what it was made of</source>
        <translation>was jede Datei ist, in welchem Koordinatensystem, mit ihrer Prüfsumme, und woraus sie entstand</translation>
    </message>
    <message>
        <source>a package of nothing: choose a format</source>
        <translation>ein leeres Paket: ein Format wählen</translation>
    </message>
    <message>
        <source>the package would hold {} twice</source>
        <translation>das Paket enthielte {} zweimal</translation>
    </message>
    <message>
        <source>The zip archive could not be made: {}</source>
        <translation>Das Zip-Archiv konnte nicht erstellt werden: {}</translation>
    </message>
    <message>
        <source>report with verdict, pictures, checks and tables, to be sent or printed</source>
        <translation>Bericht mit Urteil, Bildern, Prüfungen und Tabellen, zum Versenden oder Drucken</translation>
    </message>
    <message>
        <source>the same report for a browser, in one file</source>
        <translation>derselbe Bericht für einen Browser, in einer Datei</translation>
    </message>
    <message>
        <source>a cell of this patch on a path from its origin, which has none itself</source>
        <translation>eine Zelle dieses Hautstücks auf einem Weg von seinem Ursprung, der selbst keine hat</translation>
    </message>
    <message>
        <source>{} and {} others</source>
        <comment>the end of a long list</comment>
        <translation>{} und {} weitere</translation>
    </message>
    <message>
        <source>expected a name that ends in .hexo, found &quot;{}&quot;</source>
        <translation>erwartet wird ein Name, der auf .hexo endet, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>exists already; a capture never replaces a session</source>
        <translation>gibt es schon; eine Aufnahme ersetzt nie eine Sitzung</translation>
    </message>
    <message>
        <source>this device does not turn by itself</source>
        <translation>dieses Gerät dreht sich nicht selbst</translation>
    </message>
    <message>
        <source>auto needs a device that turns by itself, and this one can&apos;t</source>
        <translation>die Automatik braucht ein Gerät, das sich selbst dreht, und dieses kann es nicht</translation>
    </message>
    <message>
        <source>The device does not turn there: {}</source>
        <translation>Das Gerät dreht sich nicht dorthin: {}</translation>
    </message>
    <message>
        <source>refused to turn {} times, the last time: {}</source>
        <translation>hat sich {}-mal geweigert, sich zu drehen, zuletzt: {}</translation>
    </message>
    <message>
        <source>ended before a skin described itself</source>
        <translation>endete, bevor sich eine Haut beschrieb</translation>
    </message>
    <message>
        <source>no skin has described itself yet; that is noticed while the next pose is waited for</source>
        <translation>noch keine Haut hat sich beschrieben; bemerkt wird das, während auf die nächste Pose gewartet wird</translation>
    </message>
    <message>
        <source>a length in metres, from {} to {}</source>
        <translation>eine Länge in Metern, von {} bis {}</translation>
    </message>
    <message>
        <source>there is no such file, nor such a built-in cell model; built in: {}</source>
        <translation>es gibt weder eine solche Datei noch ein solches eingebautes Zellmodell; eingebaut: {}</translation>
    </message>
    <message>
        <source>folder of tables: cells, sensors, links, poses, residuals, covariances</source>
        <translation>Ordner mit Tabellen: Zellen, Sensoren, Verbindungen, Posen, Abweichungen, Kovarianzen</translation>
    </message>
    <message>
        <source>a unit quaternion (w, x, y, z); the length of this one is {}</source>
        <translation>ein Einheitsquaternion (w, x, y, z); die Länge von diesem ist {}</translation>
    </message>
    <message>
        <source>There are enough poses.</source>
        <translation>Es sind genug Posen.</translation>
    </message>
    <message>
        <source>The capture is over.</source>
        <translation>Die Aufnahme ist zu Ende.</translation>
    </message>
    <message>
        <source>{} must be a rotation</source>
        <translation>{} muss eine Drehung sein</translation>
    </message>
    <message>
        <source>The reading of cell {} is no finite number {}; it is placed from the other poses.</source>
        <translation>Der Messwert von Zelle {} ist {} keine endliche Zahl; sie wird aus den anderen Posen verortet.</translation>
    </message>
    <message>
        <source>The readings of cell {} are no finite numbers; it is placed through its links.</source>
        <translation>Die Messwerte von Zelle {} sind keine endlichen Zahlen; sie wird über ihre Verbindungen verortet.</translation>
    </message>
    <message>
        <source>The readings of cell {} are no finite numbers, and no link joins it to another cell.</source>
        <translation>Die Messwerte von Zelle {} sind keine endlichen Zahlen, und keine Verbindung führt zu einer anderen Zelle.</translation>
    </message>
    <message>
        <source>Cell {} delivered no reading in any pose, and no link joins it to another cell.</source>
        <translation>Zelle {} hat in keiner Pose einen Messwert geliefert, und keine Verbindung führt zu einer anderen Zelle.</translation>
    </message>
    <message>
        <source>A neighbour is at port 0, which cell model {} does not have: are the ports counted from 0? Then the links at the other ports are wrong, too.</source>
        <translation>Ein Nachbar ist an Port 0, den das Zellmodell {} nicht hat: Werden die Ports von 0 an gezählt? Dann sind auch die Verbindungen an den anderen Ports falsch.</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>says {} Hz, but a cell&apos;s samples come {} times a second by the device&apos;s own clock; are ticks left out, or is time_us wrong?</source>
        <translation>sagt {} Hz, aber die Messwerte einer Zelle kommen nach der Uhr des Geräts {}-mal in der Sekunde; werden Takte ausgelassen, oder ist time_us falsch?</translation>
    </message>
    <message>
        <source>this looks like the framing of a serial port (COBS), expected a frame that begins with its length; is there a bridge from a serial port? Make a pseudo-terminal of it, and use serial:</source>
        <translation>das sieht nach der Rahmung einer seriellen Schnittstelle aus (COBS), erwartet wird ein Rahmen, der mit seiner Länge beginnt; ist eine Brücke von einer seriellen Schnittstelle dazwischen? Daraus ein Pseudoterminal machen und serial: benutzen</translation>
    </message>
    <message>
        <source>is the baud rate right? now {}</source>
        <translation>stimmt die Baudrate? jetzt {}</translation>
    </message>
    <message>
        <source>bytes came, but no frame ({})</source>
        <translation>es kamen Bytes, aber kein Rahmen ({})</translation>
    </message>
    <message>
        <source>no hello came that can be used, and the device did not answer Describe {} times: is its RX connected?</source>
        <translation>es kam kein brauchbares hello, und das Gerät hat {}-mal nicht auf Describe geantwortet: Ist sein RX angeschlossen?</translation>
    </message>
    <message>
        <source>one of the baud rates {}</source>
        <translation>eine der Baudraten {}</translation>
    </message>
    <message>
        <source>only broken bytes for {} (is the baud rate right? now {}); reconnecting in {}</source>
        <translation>seit {} nur kaputte Bytes (stimmt die Baudrate? jetzt {}); neue Verbindung in {}</translation>
    </message>
    <message>
        <source>The {} bends by {} degrees, and a skin link by no more than {}. It is probably a cable or crosses a joint, or the axes of the accelerometers are not as the cell model says.</source>
        <translation>Die {} ist um {} Grad gebogen, eine Hautverbindung höchstens um {}. Wahrscheinlich ist sie ein Kabel oder überquert ein Gelenk, oder die Achsen der Beschleunigungssensoren sind nicht so, wie das Zellmodell sagt.</translation>
    </message>
    <message>
        <source>The {} is twisted by {} degrees, and a skin link by no more than {}. It is probably a cable, or a port number or the axes of the accelerometers are wrong.</source>
        <translation>Die {} ist um {} Grad verwunden, eine Hautverbindung höchstens um {}. Wahrscheinlich ist sie ein Kabel, oder eine Portnummer oder die Achsen der Beschleunigungssensoren sind falsch.</translation>
    </message>
    <message>
        <source>The {} is turned in the surface by {} degrees, and a skin link by no more than {}. A port number is probably wrong, or it is a cable, or the axes of the accelerometers are not as the cell model says.</source>
        <translation>Die {} ist in der Fläche um {} Grad gedreht, eine Hautverbindung höchstens um {}. Wahrscheinlich ist eine Portnummer falsch, oder sie ist ein Kabel, oder die Achsen der Beschleunigungssensoren sind nicht so, wie das Zellmodell sagt.</translation>
    </message>
    <message>
        <source>no pose for {}: {}</source>
        <translation>{} lang keine Pose: {}</translation>
    </message>
    <message>
        <source>the device did not describe itself for {}: {}</source>
        <translation>das Gerät hat sich {} lang nicht beschrieben: {}</translation>
    </message>
    <message>
        <source>What is sent arrives {} times slower than the device&apos;s clock says: the line is too slow, or the device waits for it (send fewer samples, or means), or its clock runs too slow; a recording may be played slowly.</source>
        <translation>Was gesendet wird, kommt {}-mal langsamer an, als die Uhr des Geräts sagt: Die Leitung ist zu langsam, oder das Gerät wartet auf sie (weniger Messwerte oder Mittelwerte senden), oder seine Uhr geht zu langsam; eine Aufzeichnung wird vielleicht langsam abgespielt.</translation>
    </message>
    <message>
        <source>says {} Hz, but a cell&apos;s samples come {} times a second by the device&apos;s own clock; is it another rate, or is time_us wrong?</source>
        <translation>sagt {} Hz, aber die Messwerte einer Zelle kommen nach der eigenen Uhr des Geräts {}-mal in der Sekunde; ist es eine andere Rate, oder ist time_us falsch?</translation>
    </message>
    <message>
        <source>a command was sent {} times, and the device is still at it (does it begin anew each time?)</source>
        <translation>ein Befehl wurde {}-mal gesendet, und das Gerät ist noch immer dabei (fängt es jedes Mal von vorne an?)</translation>
    </message>
    <message>
        <source>Take the pose again and hold the part stiller: its motion adds to gravity, most of all far from where it is held. If it happens again, check the sensor of the cell, and the scale in which its readings are sent.</source>
        <translation>Die Pose noch einmal aufnehmen und das Teil ruhiger halten: Seine Bewegung kommt zur Schwerkraft hinzu, am meisten weit weg von der Stelle, an der es gehalten wird. Tritt es wieder auf, den Sensor der Zelle prüfen und die Skala, in der seine Messwerte gesendet werden.</translation>
    </message>
    <message>
        <source>is one of the inputs, which are never replaced: take another name</source>
        <translation>ist eine der Eingaben, die nie ersetzt werden: anderen Namen wählen</translation>
    </message>
    <message>
        <source>exists already as a Hexoderm session, and what that has captured is never replaced: take another name</source>
        <translation>gibt es schon als Sitzung von Hexoderm, und was sie aufgenommen hat, wird nie ersetzt: anderen Namen wählen</translation>
    </message>
    <message>
        <source>belongs to the session {}, and what that has captured is never replaced: take another name</source>
        <translation>gehört zur Sitzung {}, und was sie aufgenommen hat, wird nie ersetzt: anderen Namen wählen</translation>
    </message>
    <message>
        <source>has more than {} elements and attributes</source>
        <translation>hat mehr als {} Elemente und Attribute</translation>
    </message>
    <message>
        <source>this is not well-formed XML ({}; truncated?), expected COLLADA</source>
        <translation>Das ist kein wohlgeformtes XML ({}; abgeschnitten?), erwartet wird COLLADA</translation>
    </message>
    <message>
        <source>expected COLLADA, whose root element is &lt;COLLADA&gt;, found &lt;{}&gt;</source>
        <translation>Erwartet wird COLLADA mit dem Wurzelelement &lt;COLLADA&gt;, gefunden wurde &lt;{}&gt;</translation>
    </message>
    <message>
        <source>expected a scene, but it has none</source>
        <translation>Erwartet wird eine Szene, es gibt aber keine</translation>
    </message>
    <message>
        <source>expected nodes without &lt;skew&gt;, which is not read</source>
        <translation>Erwartet werden Knoten ohne &lt;skew&gt;, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>expected polygons without holes, which are not read</source>
        <translation>Erwartet werden Vielecke ohne Löcher, die nicht gelesen werden</translation>
    </message>
    <message>
        <source>expected positions in &lt;{}&gt;</source>
        <translation>Erwartet werden Positionen in &lt;{}&gt;</translation>
    </message>
    <message>
        <source>glTF of version 2</source>
        <translation>glTF der Version 2</translation>
    </message>
    <message>
        <source>needs the extension {} of glTF, which is not read</source>
        <translation>braucht die glTF-Erweiterung {}, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>an accessor that is not sparse</source>
        <translation>ein Accessor, der nicht dünn besetzt ist</translation>
    </message>
    <message>
        <source>a buffer with a uri</source>
        <translation>ein Puffer mit uri</translation>
    </message>
    <message>
        <source>data in base64</source>
        <translation>Daten in Base64</translation>
    </message>
    <message>
        <source>a corner of triangle {} is not finite or farther than {} from the origin</source>
        <translation>Eine Ecke von Dreieck {} ist nicht endlich oder weiter als {} vom Ursprung entfernt</translation>
    </message>
    <message>
        <source>the file ends too early (truncated?)</source>
        <translation>Die Datei endet zu früh (abgeschnitten?)</translation>
    </message>
    <message>
        <source>a triangle has a corner at point {}, but there are {} points</source>
        <translation>Ein Dreieck hat eine Ecke bei Punkt {}, es gibt aber nur {} Punkte</translation>
    </message>
    <message>
        <source>has more than {} nodes, or nodes that contain themselves</source>
        <translation>hat mehr als {} Knoten oder Knoten, die sich selbst enthalten</translation>
    </message>
    <message>
        <source>the number of a point</source>
        <translation>die Nummer eines Punkts</translation>
    </message>
    <message>
        <source>expected the end of the header, end_header</source>
        <translation>Erwartet wird das Ende des Kopfs, end_header</translation>
    </message>
    <message>
        <source>PLY of ascii, binary_little_endian or binary_big_endian</source>
        <translation>PLY in ascii, binary_little_endian oder binary_big_endian</translation>
    </message>
    <message>
        <source>expected the properties x, y and z of each vertex</source>
        <translation>Erwartet werden die Eigenschaften x, y und z jeder Ecke</translation>
    </message>
    <message>
        <source>a facet of an STL file</source>
        <translation>eine Facette einer STL-Datei</translation>
    </message>
    <message>
        <source>expected a mesh as STL, OBJ, COLLADA, glTF or PLY, found &quot;{}&quot;</source>
        <translation>Erwartet wird ein Netz als STL, OBJ, COLLADA, glTF oder PLY, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>no &lt;{}&gt; in the file has the address &quot;{}&quot;</source>
        <translation>Kein &lt;{}&gt; in der Datei hat die Adresse „{}“</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has too few, too many or malformed numbers</source>
        <translation>&lt;{}&gt; hat zu wenige, zu viele oder fehlerhafte Zahlen</translation>
    </message>
    <message>
        <source>an index below {}</source>
        <translation>ein Index unter {}</translation>
    </message>
    <message>
        <source>indices below {}</source>
        <translation>Indizes unter {}</translation>
    </message>
    <message>
        <source>a number type</source>
        <translation>ein Zahlentyp</translation>
    </message>
    <message>
        <source>a data URI or a relative path</source>
        <translation>ein Data-URI oder ein relativer Pfad</translation>
    </message>
    <message>
        <source>{} No path of used links connects its two cells any more: the patch is split there.</source>
        <translation>{} Kein Weg über benutzte Verbindungen führt mehr von der einen ihrer beiden Zellen zur anderen: Dort zerfällt das Hautstück.</translation>
    </message>
    <message>
        <source>{} It alone connects parts of the patch, whose relative placement is less certain.</source>
        <translation>{} Sie allein verbindet Teile des Hautstücks, deren Lage zueinander weniger sicher ist.</translation>
    </message>
    <message>
        <source>With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than {}. All of its loops have {} links in common, and any one of these may be a cable. The link is not used.</source>
        <translation>Mit allen anderen Verbindungen liegen die Enden der {} {} auseinander, bei einer Hautverbindung höchstens {}. Alle ihre Schleifen haben {} Verbindungen gemeinsam, und jede davon kann ein Kabel sein. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than {}: it is probably a cable, since no other link is in all of its loops. The link is not used.</source>
        <translation>Mit allen anderen Verbindungen liegen die Enden der {} {} auseinander, bei einer Hautverbindung höchstens {}: Wahrscheinlich ist sie ein Kabel, denn keine andere Verbindung liegt in allen ihren Schleifen. Die Verbindung wird nicht benutzt.</translation>
    </message>
    <message>
        <source>{} lies beside it, and would be taken for a part of it: move that file away, or take another name</source>
        <translation>{} liegt daneben und würde für einen Teil davon gehalten: Verschieben Sie diese Datei, oder nehmen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>belongs to a session, and what that has captured is never replaced: take another name</source>
        <translation>gehört zu einer Sitzung, und was diese aufgenommen hat, wird nie ersetzt: Nehmen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>{} lies beside it, with what a session of that name has captured: move that file away, or take another name</source>
        <translation>{} liegt daneben, mit dem, was eine Sitzung dieses Namens aufgenommen hat: Verschieben Sie diese Datei, oder nehmen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>has {} {}, but at most {} are read</source>
        <translation>hat {} {}, gelesen werden höchstens {}</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>corners in one polygon</source>
        <translation>Ecken in einem Vieleck</translation>
    </message>
    <message>
        <source>rows of the element &quot;{}&quot;</source>
        <translation>Zeilen des Elements „{}“</translation>
    </message>
    <message>
        <source>expected a mesh file, but this one is empty</source>
        <translation>erwartet ist eine Netzdatei, doch diese ist leer</translation>
    </message>
    <message>
        <source>takes more memory than there is</source>
        <translation>braucht mehr Speicher, als da ist</translation>
    </message>
    <message>
        <source>has no triangle with an area</source>
        <translation>hat kein Dreieck mit einer Fläche</translation>
    </message>
    <message>
        <source>the mesh has no triangle with an area</source>
        <translation>das Netz hat kein Dreieck mit einer Fläche</translation>
    </message>
    <message>
        <source>its shapes have {} triangles together, but at most {} are read</source>
        <translation>seine Formen haben zusammen {} Dreiecke, gelesen werden höchstens {}</translation>
    </message>
    <message>
        <source>an element has more than {} attributes</source>
        <translation>ein Element hat mehr als {} Attribute</translation>
    </message>
    <message>
        <source>&lt;{} name=&quot;{}&quot;&gt;: expected at most {} characters</source>
        <translation>&lt;{} name=&quot;{}&quot;&gt;: erwartet sind höchstens {} Zeichen</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has no {}: expected {}</source>
        <translation>&lt;{}&gt; hat kein {}: erwartet ist {}</translation>
    </message>
    <message>
        <source>&lt;{} {}=&quot;{}&quot;&gt;: expected {}</source>
        <translation>&lt;{} {}=&quot;{}&quot;&gt;: erwartet ist {}</translation>
    </message>
    <message>
        <source>a length above 0 and at most {} m</source>
        <translation>eine Länge über 0 und bis {} m</translation>
    </message>
    <message>
        <source>three coordinates within {} m, separated by blanks</source>
        <translation>drei Koordinaten bis {} m, durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>package://NAME/FILE, file:///FILE or a path</source>
        <translation>package://NAME/DATEI, file:///DATEI oder ein Pfad</translation>
    </message>
    <message>
        <source>three lengths above 0 and at most {} m, separated by blanks</source>
        <translation>drei Längen über 0 und bis {} m, durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>&lt;{}&gt;: expected a box, cylinder, sphere or mesh</source>
        <translation>&lt;{}&gt;: erwartet ist box, cylinder, sphere oder mesh</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has no &lt;geometry&gt; with a box, cylinder, sphere or mesh</source>
        <translation>&lt;{}&gt; hat keine &lt;geometry&gt; mit box, cylinder, sphere oder mesh</translation>
    </message>
    <message>
        <source>true radius: expected metres above 0 and at most {}, found {}</source>
        <translation>wahrer Radius: erwartet sind Meter über 0 und bis {}, gefunden {}</translation>
    </message>
    <message>
        <source>{} must be from {} to {} m, found {} m</source>
        <translation>{}: erwartet ist {} bis {} m, gefunden {} m</translation>
    </message>
    <message>
        <source>the cells&apos; thickness</source>
        <translation>die Dicke der Zellen</translation>
    </message>
    <message>
        <source>Link {} is too large to look for the patch of cell {} all over it: {} m from corner to corner, where the patch measures {} from cell to cell. A URDF counts in metres: a mesh in millimetres needs scale=&quot;0.001 0.001 0.001&quot; there, with which the link would measure {}.</source>
        <translation>Glied {} ist zu groß, um das Hautstück von Zelle {} überall darauf zu suchen: {} m von Ecke zu Ecke, während das Hautstück von Zelle zu Zelle {} misst. Eine URDF zählt in Metern: Ein Netz in Millimetern braucht dort scale=&quot;0.001 0.001 0.001&quot;; damit wäre das Glied {} groß.</translation>
    </message>
    <message>
        <source>each coordinate of the point of cell {}</source>
        <translation>jede Koordinate des Punkts von Zelle {}</translation>
    </message>
    <message>
        <source>the sigma of the normals must be from {} to {}, found {}°</source>
        <translation>das Sigma der Normalen: erwartet ist {} bis {}, gefunden {}°</translation>
    </message>
    <message>
        <source>the gap</source>
        <translation>der Spalt</translation>
    </message>
    <message>
        <source>{} must be above 0 and at most {}</source>
        <translation>{} muss über 0 liegen und höchstens {} sein</translation>
    </message>
    <message>
        <source>pose {} is not stored</source>
        <translation>Pose {} ist nicht gespeichert</translation>
    </message>
    <message>
        <source>poses {} are not stored</source>
        <translation>Posen {} sind nicht gespeichert</translation>
    </message>
    <message>
        <source>1 pose was stored before</source>
        <translation>1 Pose wurde vorher gespeichert</translation>
    </message>
    <message>
        <source>{} poses were stored before</source>
        <translation>{} Posen wurden vorher gespeichert</translation>
    </message>
    <message>
        <source>it was moved to {} while it was written, with what was recorded before</source>
        <translation>sie wurde während des Schreibens nach {} verschoben, mit dem, was vorher aufgezeichnet war</translation>
    </message>
    <message>
        <source>it was removed while it was written, with what was recorded before</source>
        <translation>sie wurde während des Schreibens entfernt, mit dem, was vorher aufgezeichnet war</translation>
    </message>
    <message>
        <source>was moved to {} while it was open</source>
        <translation>wurde nach {} verschoben, während die Datei offen war</translation>
    </message>
    <message>
        <source>was removed while it was open</source>
        <translation>wurde entfernt, während die Datei offen war</translation>
    </message>
    <message>
        <source>{}, with what was stored in it; it can&apos;t be written anew: {}</source>
        <translation>{}, mit dem, was darin gespeichert war; sie lässt sich nicht neu schreiben: {}</translation>
    </message>
    <message>
        <source>{}; the whole session was written anew</source>
        <translation>{}; die ganze Sitzung wurde neu geschrieben</translation>
    </message>
    <message>
        <source>the disk is full: free some space; what was stored before is intact</source>
        <translation>der Datenträger ist voll: Platz schaffen; was vorher gespeichert war, ist unversehrt</translation>
    </message>
    <message>
        <source>expected three coordinates, found the end of the line</source>
        <translation>erwartet sind drei Koordinaten, gefunden wurde das Ende der Zeile</translation>
    </message>
    <message>
        <source>states {} triangles, but has the bytes of {}: expected as many as it states</source>
        <translation>nennt {} Dreiecke, hat aber die Bytes von {}: So viele, wie sie nennt, werden erwartet</translation>
    </message>
    <message>
        <source>expected an axis of three numbers within {}</source>
        <translation>Eine Achse aus drei Zahlen, dem Betrag nach höchstens {}, wird erwartet</translation>
    </message>
    <message>
        <source>expected limits within {}; a joint without limits is of the type continuous</source>
        <translation>Grenzen, dem Betrag nach höchstens {}, werden erwartet; ein Gelenk ohne Grenzen hat den Typ continuous</translation>
    </message>
    <message>
        <source>expected a multiplier and an offset within {}</source>
        <translation>Ein Faktor und ein Versatz, dem Betrag nach höchstens {}, werden erwartet</translation>
    </message>
    <message>
        <source>the DOCTYPE has definitions, entities for example, which are not read: expected a URDF without them, with each entity replaced by its text</source>
        <translation>die DOCTYPE enthält Definitionen, etwa Entitäten, die nicht gelesen werden: Erwartet wird eine URDF ohne sie, in der statt jeder Entität ihr Text steht</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has the attribute {} twice: expected each attribute once</source>
        <translation>&lt;{}&gt; hat das Attribut {} zweimal: Jedes Attribut wird nur einmal erwartet</translation>
    </message>
    <message>
        <source>three numbers within {}, none of them 0, separated by blanks</source>
        <translation>drei Zahlen, dem Betrag nach höchstens {}, keine davon 0, durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>&lt;{}&gt; has a second &lt;geometry&gt;: expected one, and another &lt;{}&gt; for each further shape</source>
        <translation>&lt;{}&gt; hat eine zweite &lt;geometry&gt;: Erwartet wird eine, und für jede weitere Form ein weiteres &lt;{}&gt;</translation>
    </message>
    <message>
        <source>&lt;geometry&gt; has a second shape, &lt;{}&gt;: expected one, and another &lt;{}&gt; for each further shape</source>
        <translation>&lt;geometry&gt; hat eine zweite Form, &lt;{}&gt;: Erwartet wird eine, und für jede weitere ein weiteres &lt;{}&gt;</translation>
    </message>
    <message>
        <source>three angles within {} rad, separated by blanks</source>
        <translation>drei Winkel, dem Betrag nach höchstens {} rad, durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>offset {}, {}, {} +- {} mg, scale {} +- {} (1 sigma)</source>
        <translation>Offset {}, {}, {} ± {} mg, Skalierung {} ± {} (1 Sigma)</translation>
    </message>
    <message>
        <source>After all that was found the readings or links still do not fit the model: the result is not to be trusted.</source>
        <translation>Nach allem, was gefunden wurde, passen Messwerte oder Verbindungen immer noch nicht zum Modell: Dem Ergebnis ist nicht zu trauen.</translation>
    </message>
    <message>
        <source>What is left unexplained is far larger than the model&apos;s own uncertainties can explain.</source>
        <translation>Was unerklärt bleibt, ist weit größer, als die Unsicherheiten des Modells erklären.</translation>
    </message>
    <message>
        <source>Check the cell model and the findings, and take the poses again with the part held still.</source>
        <translation>Das Zellmodell und die Befunde prüfen und die Posen noch einmal aufnehmen, während das Teil stillgehalten wird.</translation>
    </message>
    <message>
        <source>&quot;good&quot;, &quot;usable&quot;, &quot;coarse&quot;, &quot;not_enough&quot;, &quot;not_trusted&quot; or &quot;failed&quot;</source>
        <translation>„good“, „usable“, „coarse“, „not_enough“, „not_trusted“ oder „failed“</translation>
    </message>
    <message>
        <source>around cell {}</source>
        <translation>um Zelle {}</translation>
    </message>
    <message>
        <source>in the patch of cell {}</source>
        <translation>im Hautstück von Zelle {}</translation>
    </message>
    <message>
        <source>The readings {} still contradict each other, by {} times what noise and the sensors&apos; errors explain.</source>
        <translation>Die Messwerte {} widersprechen einander immer noch, um das {}-Fache dessen, was Rauschen und Sensorfehler erklären.</translation>
    </message>
    <message>
        <source>The links {} are still turned by {} times what the elastomer allows.</source>
        <translation>Die Verbindungen {} sind immer noch um das {}-Fache dessen verdreht, was das Elastomer zulässt.</translation>
    </message>
    <message>
        <source>The loops of links {} still don&apos;t close, by {} times what the others leave open.</source>
        <translation>Die Ringe aus Verbindungen {} schließen sich immer noch nicht, um das {}-Fache dessen, was die anderen offen lassen.</translation>
    </message>
    <message>
        <source>Something is wrong with the readings of {} of {} cells: too many to tell which are right.</source>
        <translation>Mit den Messwerten von {} von {} Zellen stimmt etwas nicht: zu viele, um zu sagen, welche richtig sind.</translation>
    </message>
    <message>
        <source>The skin fell apart at {} links that do not fit it, and nothing says that there is a joint.</source>
        <translation>Die Haut zerfiel an {} Verbindungen, die nicht zu ihr passen, und nichts sagt, dass dort ein Gelenk ist.</translation>
    </message>
    <message>
        <source>Not to be trusted: {}</source>
        <translation>Nicht vertrauenswürdig: {}</translation>
    </message>
    <message>
        <source>Look at the findings, and compare the cell model, the cells and their links with the skin.</source>
        <translation>Die Befunde ansehen und Zellmodell, Zellen und Verbindungen mit der Haut vergleichen.</translation>
    </message>
    <message>
        <source>Coarse: {}, {}.</source>
        <translation>Grob: {}, {}.</translation>
    </message>
    <message>
        <source>What limits it is mostly how the cells lie in the mould: another pose would bring {}.</source>
        <translation>Grenze ist vor allem, wie die Zellen in der Form liegen: Eine weitere Pose brächte {}.</translation>
    </message>
    <message>
        <source>The {} patches, which a joint or the robot holds together, lie each in the frame of its own origin.</source>
        <translation>Die {} Hautstücke, die ein Gelenk oder der Roboter zusammenhält, liegen jedes im Koordinatensystem seines eigenen Ursprungs.</translation>
    </message>
    <message>
        <source>Take {} again. That should bring {}.</source>
        <translation>{} noch einmal aufnehmen. Das sollte {} bringen.</translation>
    </message>
    <message>
        <source>±{} to about ±{}</source>
        <translation>±{} auf etwa ±{}</translation>
    </message>
    <message>
        <source>That should bring {}.</source>
        <translation>Das sollte {} bringen.</translation>
    </message>
    <message>
        <source>Links along one line fit no skin: the skin is torn there, or a joint or cables cross it. All its links are named, end by end, and muted.</source>
        <translation>Verbindungen entlang einer Linie passen in keine Haut: Dort ist die Haut gerissen, oder ein Gelenk oder Kabel queren sie. Alle diese Verbindungen sind mit ihren Enden genannt und ausgeschlossen.</translation>
    </message>
    <message>
        <source>The links lie side by side, and without them both sides fit.</source>
        <translation>Die Verbindungen liegen nebeneinander, und ohne sie passen beide Seiten.</translation>
    </message>
    <message>
        <source>Look along the line of links. If a joint or cables cross it, leave them muted. If the skin is whole there, check the cells beside it.</source>
        <translation>Sehen Sie die Linie der Verbindungen entlang. Wenn ein Gelenk oder Kabel sie queren, lassen Sie sie ausgeschlossen. Wenn die Haut dort ganz ist, prüfen Sie die Zellen daneben.</translation>
    </message>
    <message>
        <source>&quot;convex&quot; or &quot;concave&quot;</source>
        <translation>„convex“ oder „concave“</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>{} links that lie side by side fit no skin, from the {} to the {}: the skin is torn along them, or a joint or cables lie between its two sides. The links are not used.</source>
        <translation>{} Verbindungen, die nebeneinander liegen, passen in keine Haut, von der {} bis zur {}: Die Haut ist dort gerissen, oder zwischen ihren beiden Seiten liegen ein Gelenk oder Kabel. Die Verbindungen werden nicht benutzt.</translation>
    </message>
    <message>
        <source>After {} findings the readings still do not fit the model, and the search was ended: there is one cause behind them that it does not know, or most of the skin is faulty.</source>
        <translation>Nach {} Befunden passen die Messwerte noch immer nicht zum Modell, und die Suche wurde beendet: Dahinter steht eine Ursache, die es nicht kennt, oder das meiste der Haut ist schadhaft.</translation>
    </message>
    <message>
        <source>In pose {} the cells do not feel one and the same gravity, as they do in the others: the part was in motion. The pose is not used; take it again.</source>
        <translation>In Pose {} spüren die Zellen nicht ein und dieselbe Schwerkraft wie in den anderen: Das Teil war in Bewegung. Die Pose wird nicht benutzt; nehmen Sie sie noch einmal auf.</translation>
    </message>
    <message>
        <source>The links fit if every cell has the readings of the cell with the next ID: the IDs of the readings are shifted by one. Connect the skin again. No other fault was looked for.</source>
        <translation>Die Verbindungen passen, wenn jede Zelle die Messwerte der Zelle mit der nächsten ID hat: Die IDs der Messwerte sind um eins verschoben. Verbinden Sie die Haut neu. Nach anderen Fehlern wurde nicht gesucht.</translation>
    </message>
</context>
<context>
    <name>hexoderm::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>hexoderm::OpenGlWords</name>
    <message>
        <source>no OpenGL 3.2</source>
        <translation>kein OpenGL 3.2</translation>
    </message>
    <message>
        <source>unknown renderer</source>
        <translation>unbekannter Zeichner</translation>
    </message>
    <message>
        <source>%1, in software</source>
        <translation>%1, in Software</translation>
    </message>
</context>
<context>
    <name>hexoderm::PackageDialog</name>
    <message>
        <source>Export package</source>
        <translation>Paket exportieren</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Files of the package</source>
        <translation>Dateien des Pakets</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>What it holds</source>
        <translation>Was sie enthält</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Cancelling …</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 is written: %2 files. The archive was read back from the disk and compared byte for byte.</source>
        <translation>%1 ist geschrieben: %2 Dateien. Das Archiv wurde vom Datenträger zurückgelesen und Byte für Byte verglichen.</translation>
    </message>
    <message>
        <source>%1 is written: %2 files. Each was read back from the disk and compared byte for byte.</source>
        <translation>%1 ist geschrieben: %2 Dateien. Jede wurde vom Datenträger zurückgelesen und Byte für Byte verglichen.</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>Nichts wurde geschrieben. %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::PackageList</name>
    <message>
        <source>Files of the package</source>
        <translation>Dateien des Pakets</translation>
    </message>
    <message>
        <source>Report, PDF</source>
        <translation>Bericht, PDF</translation>
    </message>
    <message>
        <source>verdict, pictures, checks and tables, to be sent or printed</source>
        <translation>Urteil, Bilder, Prüfungen und Tabellen, zum Versenden oder Drucken</translation>
    </message>
    <message>
        <source>Report, HTML</source>
        <translation>Bericht, HTML</translation>
    </message>
    <message>
        <source>the same for a browser, in one file</source>
        <translation>dasselbe für einen Browser, in einer Datei</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>everything that is known, in Hexoderm&apos;s own file</source>
        <translation>alles, was bekannt ist, in Hexoderms eigener Datei</translation>
    </message>
</context>
<context>
    <name>hexoderm::Palette</name>
    <message>
        <source>un-defined</source>
        <translation>unbestimmt</translation>
    </message>
    <message>
        <source>partially defined</source>
        <translation>teilweise bestimmt</translation>
    </message>
    <message>
        <source>fully defined</source>
        <translation>voll bestimmt</translation>
    </message>
    <message>
        <source>over-defined</source>
        <translation>überbestimmt</translation>
    </message>
</context>
<context>
    <name>hexoderm::Panels</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Skin graph</source>
        <translation>Hautgraph</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>No poses yet.</source>
        <translation>Noch keine Posen.</translation>
    </message>
    <message>
        <source>Directions seen</source>
        <translation>Gesehene Richtungen</translation>
    </message>
    <message>
        <source>The patch in three dimensions</source>
        <translation>Das Hautstück in drei Dimensionen</translation>
    </message>
    <message>
        <source>No findings.</source>
        <translation>Keine Befunde.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>No links yet.</source>
        <translation>Noch keine Verbindungen.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>No cells yet.</source>
        <translation>Noch keine Zellen.</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Stillness</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Findings and links</source>
        <translation>Befunde und Verbindungen</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Skin patch</source>
        <translation>Hautstück</translation>
    </message>
</context>
<context>
    <name>hexoderm::PartMotion</name>
    <message>
        <source>Turn the part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>Dragging and the arrow keys turn the part instead of the picture; dragging with Shift always does</source>
        <translation>Ziehen und Pfeiltasten drehen das Teil statt des Bildes; Ziehen mit Umschalt tut das immer</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchCaptions</name>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>next pose</source>
        <translation>nächste Pose</translation>
    </message>
    <message>
        <source>next pose, %1</source>
        <translation>nächste Pose, %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchControls</name>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>Parallel&amp;projektion</translation>
    </message>
    <message>
        <source>Save picture of the 3D &amp;view…</source>
        <translation>Bild der 3D-&amp;Ansicht speichern…</translation>
    </message>
    <message>
        <source>Distance between two cells, and the angle between their faces</source>
        <translation>Abstand zweier Zellen und Winkel zwischen ihren Flächen</translation>
    </message>
    <message>
        <source>Without perspective: equal lengths look equally long wherever they are</source>
        <translation>Ohne Perspektive: Gleiche Längen sehen überall gleich lang aus</translation>
    </message>
    <message>
        <source>The scene with its legend as an image file</source>
        <translation>Die Szene mit ihrer Legende als Bilddatei</translation>
    </message>
    <message>
        <source>What the cells&apos; colour shows</source>
        <translation>Was die Farbe der Zellen zeigt</translation>
    </message>
    <message>
        <source>Colour: %1 ▾</source>
        <translation>Farbe: %1 ▾</translation>
    </message>
    <message>
        <source>Colour of the cells: %1</source>
        <translation>Farbe der Zellen: %1</translation>
    </message>
    <message>
        <source>Show ▾</source>
        <translation>Zeigen ▾</translation>
    </message>
    <message>
        <source>What is drawn over the cells, and how</source>
        <translation>Was über die Zellen gezeichnet wird, und wie</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look at the origin cell&apos;s front face</source>
        <translation>Auf die Vorderseite der Ursprungszelle sehen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Look along the origin cell&apos;s x axis</source>
        <translation>Entlang der x-Achse der Ursprungszelle sehen</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Look along the origin cell&apos;s y axis</source>
        <translation>Entlang der y-Achse der Ursprungszelle sehen</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet von %1</translation>
    </message>
    <message>
        <source>&amp;Cut open</source>
        <translation>Au&amp;fschneiden</translation>
    </message>
    <message>
        <source>Show the whole skin, and all that is drawn with it</source>
        <translation>Die ganze Haut zeigen und alles, was mit ihr gezeichnet ist</translation>
    </message>
    <message>
        <source>Takes away what is nearer to you than a plane, so that you see what lies behind</source>
        <translation>Nimmt weg, was vor einer Ebene liegt, sodass zu sehen ist, was dahinter ist</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>Far&amp;be</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>View ▾</source>
        <translation>Ansicht ▾</translation>
    </message>
    <message>
        <source>From where the skin is looked at, and how</source>
        <translation>Von wo und wie die Haut angesehen wird</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Look at the origin cell from behind</source>
        <translation>Von hinten auf die Ursprungszelle sehen</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Look from between the three axes</source>
        <translation>Von zwischen den drei Achsen sehen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchLegend</name>
    <message>
        <source>no link</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Cells are coloured by: %1</source>
        <translation>Farbe der Zellen: %1</translation>
    </message>
    <message>
        <source>error found</source>
        <translation>Fehler gefunden</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>placed through its links</source>
        <translation>durch ihre Verbindungen verortet</translation>
    </message>
    <message>
        <source>link with a finding</source>
        <translation>Verbindung mit Befund</translation>
    </message>
    <message>
        <source>fixed range</source>
        <translation>fester Bereich</translation>
    </message>
    <message>
        <source>fitted range</source>
        <translation>angepasster Bereich</translation>
    </message>
    <message>
        <source>usual range</source>
        <translation>üblicher Bereich</translation>
    </message>
    <message>
        <source>Cells are coloured by: %1; %2</source>
        <translation>Farbe der Zellen: %1; %2</translation>
    </message>
    <message>
        <source>crossed cells: an error was found in their readings</source>
        <translation>durchkreuzte Zellen: in ihren Messwerten wurde ein Fehler gefunden</translation>
    </message>
    <message>
        <source>cells with a triangle: a warning about their readings</source>
        <translation>Zellen mit Dreieck: eine Warnung zu ihren Messwerten</translation>
    </message>
    <message>
        <source>hatched cells: placed through their links alone</source>
        <translation>schraffierte Zellen: allein durch ihre Verbindungen verortet</translation>
    </message>
    <message>
        <source>crossed ports: a link with a finding</source>
        <translation>durchkreuzte Ports: eine Verbindung mit einem Befund</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchLegendView</name>
    <message>
        <source>The range of the colours: fitted to what is shown, the usual one, or as you type it</source>
        <translation>Der Bereich der Farben: an das Gezeigte angepasst, der übliche oder einer, den Sie eingeben</translation>
    </message>
    <message>
        <source>Range of the colours: %1</source>
        <translation>Bereich der Farben: %1</translation>
    </message>
    <message>
        <source>Scale of the colours: %1</source>
        <translation>Skala der Farben: %1</translation>
    </message>
    <message>
        <source>Legend of the colours</source>
        <translation>Legende der Farben</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchMenu</name>
    <message>
        <source>&amp;Pick cell %1</source>
        <translation>Zelle %1 &amp;wählen</translation>
    </message>
    <message>
        <source>&amp;Bring cell %1 into the middle</source>
        <translation>Zelle %1 &amp;in die Mitte holen</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Blick &amp;von</translation>
    </message>
    <message>
        <source>Copy pict&amp;ure</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>The scene with its legend, to be pasted elsewhere</source>
        <translation>Die Szene mit ihrer Legende, um sie anderswo einzufügen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchPointing</name>
    <message>
        <source>Figures of what is picked</source>
        <translation>Werte des Ausgewählten</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>Zelle %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchView</name>
    <message>
        <source>Skin patch in 3D</source>
        <translation>Hautstück in 3D</translation>
    </message>
    <message>
        <source>No skin yet: open a session or start the demo.</source>
        <translation>Noch keine Haut: eine Sitzung öffnen oder die Demo starten.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2, which is not available here. The graph and the tables still work.

On a remote desktop, or with a faulty driver, it may help to let the processor draw: Edit, Preferences, &quot;Draw without the graphics card&quot;, then start Hexoderm again.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2, das es hier nicht gibt. Graph und Tabellen arbeiten trotzdem.

Auf einem entfernten Bildschirm oder mit einem fehlerhaften Treiber kann es helfen, den Prozessor zeichnen zu lassen: Bearbeiten, Einstellungen, &quot;Ohne Grafikkarte zeichnen&quot;, dann Hexoderm neu starten.</translation>
    </message>
    <message>
        <source>Preparing the picture of %1 cells…</source>
        <translation>Das Bild von %1 Zellen wird vorbereitet…</translation>
    </message>
    <message>
        <source>This skin has no cells.</source>
        <translation>Diese Haut hat keine Zellen.</translation>
    </message>
    <message>
        <source>cell %1: %2</source>
        <translation>Zelle %1: %2</translation>
    </message>
</context>
<context>
    <name>hexoderm::PatchWords</name>
    <message>
        <source>drawn %1 times as large</source>
        <translation>%1-fach vergrößert gezeichnet</translation>
    </message>
    <message>
        <source>true to scale</source>
        <translation>maßstäblich</translation>
    </message>
    <message>
        <source>This result states no uncertainties</source>
        <translation>Dieses Ergebnis nennt keine Unsicherheiten</translation>
    </message>
    <message>
        <source>No surface was fitted yet</source>
        <translation>Noch ist keine Fläche angepasst</translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation>&amp;Ports</translation>
    </message>
    <message>
        <source>Cell &amp;IDs</source>
        <translation>&amp;IDs der Zellen</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Achsen</translation>
    </message>
    <message>
        <source>&amp;Gravity</source>
        <translation>&amp;Schwerkraft</translation>
    </message>
    <message>
        <source>&amp;Links by quality</source>
        <translation>&amp;Verbindungen nach Güte</translation>
    </message>
    <message>
        <source>Shortest-path t&amp;ree</source>
        <translation>&amp;Baum der kürzesten Wege</translation>
    </message>
    <message>
        <source>&amp;Uncertainty ellipsoids</source>
        <translation>&amp;Unsicherheitsellipsoide</translation>
    </message>
    <message>
        <source>&amp;Truth</source>
        <translation>&amp;Wahrheit</translation>
    </message>
    <message>
        <source>Fitted &amp;surface</source>
        <translation>Angepasste &amp;Fläche</translation>
    </message>
    <message>
        <source>L&amp;oop gap</source>
        <translation>Lücke der S&amp;chleife</translation>
    </message>
    <message>
        <source>&amp;Differences to the other calibration</source>
        <translation>&amp;Unterschiede zur anderen Kalibrierung</translation>
    </message>
    <message>
        <source>Discs where a link joins a neighbour, rings where a port is free</source>
        <translation>Scheiben, wo eine Verbindung ansetzt, Ringe, wo ein Port frei ist</translation>
    </message>
    <message>
        <source>Each cell&apos;s number, on faces that look at you</source>
        <translation>Die Nummer jeder Zelle, auf zugewandten Seiten</translation>
    </message>
    <message>
        <source>The directions of the patch&apos;s frame, which is the origin cell&apos;s</source>
        <translation>Die Richtungen im Koordinatensystem des Hautstücks, dem der Ursprungszelle</translation>
    </message>
    <message>
        <source>Where gravity points in the picked pose</source>
        <translation>Wohin die Schwerkraft in der gewählten Pose zeigt</translation>
    </message>
    <message>
        <source>Every link in the colour and line style of its class; muted links are crossed</source>
        <translation>Jede Verbindung in Farbe und Linienart ihrer Güte; ausgeschlossene sind durchgestrichen</translation>
    </message>
    <message>
        <source>The links by which every cell is reached from the origin on the shortest way</source>
        <translation>Die Verbindungen, über die jede Zelle auf kürzestem Weg vom Ursprung erreicht wird</translation>
    </message>
    <message>
        <source>The region that holds each cell&apos;s centre with 95 % probability, relative to the origin</source>
        <translation>Der Bereich, in dem die Mitte jeder Zelle mit 95 % Wahrscheinlichkeit liegt, bezogen auf den Ursprung</translation>
    </message>
    <message>
        <source>Where the simulated cells really are, moved onto the result as well as possible</source>
        <translation>Wo die simulierten Zellen wirklich sind, bestmöglich auf das Ergebnis gelegt</translation>
    </message>
    <message>
        <source>The surface fitted to the cells, with each cell&apos;s distance from it</source>
        <translation>Die an die Zellen angepasste Fläche, mit dem Abstand jeder Zelle</translation>
    </message>
    <message>
        <source>The gap between the two ports where the loop should close</source>
        <translation>Die Lücke zwischen den beiden Ports, an denen sich die Schleife schließen soll</translation>
    </message>
    <message>
        <source>From where each cell was to where it is now</source>
        <translation>Von wo jede Zelle war bis wo sie jetzt ist</translation>
    </message>
    <message>
        <source>There is no skin yet</source>
        <translation>Noch gibt es keine Haut</translation>
    </message>
    <message>
        <source>This skin has too many cells to draw them: at most %1</source>
        <translation>Diese Haut hat dafür zu viele Zellen: höchstens %1</translation>
    </message>
    <message>
        <source>Only of a simulated skin is the truth known</source>
        <translation>Nur von einer simulierten Haut ist die Wahrheit bekannt</translation>
    </message>
    <message>
        <source>No loop was evaluated yet</source>
        <translation>Noch ist keine Schleife ausgewertet</translation>
    </message>
    <message>
        <source>No comparison was made yet</source>
        <translation>Noch ist nichts verglichen</translation>
    </message>
    <message>
        <source>broad lines: the shortest-path tree</source>
        <translation>breite Linien: der Baum der kürzesten Wege</translation>
    </message>
    <message>
        <source>ellipsoids: 95 %, %1</source>
        <translation>Ellipsoide: 95 %, %1</translation>
    </message>
    <message>
        <source>outlines: the truth, moved onto the result</source>
        <translation>Umrisse: die Wahrheit, auf das Ergebnis gelegt</translation>
    </message>
    <message>
        <source>%1, radius %2</source>
        <translation>%1, Radius %2</translation>
    </message>
    <message>
        <source>; rms distance %1, lines %2</source>
        <translation>; Effektivwert der Abstände %1, Linien %2</translation>
    </message>
    <message>
        <source>loop gap: %1, %2 % of the loop; the arrow %3</source>
        <translation>Lücke der Schleife: %1, %2 % der Schleife; der Pfeil %3</translation>
    </message>
    <message>
        <source>arrows: from before to now, %1</source>
        <translation>Pfeile: von vorher zu jetzt, %1</translation>
    </message>
    <message>
        <source>Cells %1 and %2 are in different patches: how these lie to each other is not known</source>
        <translation>Die Zellen %1 und %2 sind in verschiedenen Hautstücken: Wie diese zueinander liegen, ist nicht bekannt</translation>
    </message>
    <message>
        <source>Cells %1 and %2: %3 apart, their faces %4 to each other</source>
        <translation>Zellen %1 und %2: %3 Abstand, ihre Flächen %4 zueinander</translation>
    </message>
    <message>
        <source>Cells %1 and %2: %3 ± %4 (95 %) apart, their faces %5 to each other</source>
        <translation>Zellen %1 und %2: %3 ± %4 (95 %) Abstand, ihre Flächen %5 zueinander</translation>
    </message>
    <message>
        <source>%1 patches beside the largest: how they lie to it and to each other is not known</source>
        <translation>%1 Hautstücke neben dem größten: wie sie zu ihm und zueinander liegen, ist nicht bekannt</translation>
    </message>
    <message>
        <source>dashed frame: patch of cell %1, not placed against the others</source>
        <translation>gestrichelter Rahmen: Hautstück der Zelle %1, Lage zu den anderen nicht bekannt</translation>
    </message>
    <message>
        <source>dashed frames: patches of cells %1, not placed against the others</source>
        <translation>gestrichelte Rahmen: Hautstücke der Zellen %1, Lage zu den anderen nicht bekannt</translation>
    </message>
</context>
<context>
    <name>hexoderm::PickedCommands</name>
    <message>
        <source>The next capture takes the place of pose %1. Hold the part as it was held then.</source>
        <translation>Die nächste Aufnahme tritt an die Stelle von Pose %1. Das Teil halten wie damals.</translation>
    </message>
    <message>
        <source>Don&apos;t recapture</source>
        <translation>Nicht neu aufnehmen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PicturePresenter</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Bild der 3D-Ansicht speichern</translation>
    </message>
    <message>
        <source>-3d</source>
        <translation>-3d</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save a picture of the graph</source>
        <translation>Bild des Graphen speichern</translation>
    </message>
    <message>
        <source>-graph</source>
        <translation>-graph</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg);;Pictures (*.png)</source>
        <translation>Vektorgrafik (*.svg);;Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlaceDecisions</name>
    <message>
        <source>use the surface of the link</source>
        <translation>Oberfläche des Glieds verwenden</translation>
    </message>
    <message>
        <source>do without the surface of the link</source>
        <translation>auf die Oberfläche des Glieds verzichten</translation>
    </message>
    <message>
        <source>remove a known point</source>
        <translation>bekannten Punkt entfernen</translation>
    </message>
    <message>
        <source>remove a measured distance</source>
        <translation>gemessenen Abstand entfernen</translation>
    </message>
    <message>
        <source>take the patch away</source>
        <translation>Hautstück wegnehmen</translation>
    </message>
    <message>
        <source>leave the link open</source>
        <translation>Glied offenlassen</translation>
    </message>
    <message>
        <source>put the patch on link %1</source>
        <translation>Hautstück auf Glied %1 legen</translation>
    </message>
    <message>
        <source>Cell %1 is none of this patch.</source>
        <translation>Zelle %1 gehört nicht zu diesem Hautstück.</translation>
    </message>
    <message>
        <source>add a known point</source>
        <translation>bekannten Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Cell %1 is of no other patch: inside a patch, distances are known.</source>
        <translation>Zelle %1 gehört zu keinem anderen Hautstück: Innerhalb eines Hautstücks sind Abstände bekannt.</translation>
    </message>
    <message>
        <source>The patch of cell %1 is not on link %2: its distance depends on the joints.</source>
        <translation>Das Hautstück von Zelle %1 liegt nicht auf Glied %2: Sein Abstand hängt von den Gelenken ab.</translation>
    </message>
    <message>
        <source>add a measured distance</source>
        <translation>gemessenen Abstand hinzufügen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlaceOnRobot</name>
    <message>
        <source>%1 · can&apos;t be told from %2</source>
        <translation>%1 · nicht von %2 zu unterscheiden</translation>
    </message>
    <message>
        <source>%1 · fits: misfit %2, usual is %3</source>
        <translation>%1 · passt: Abweichung %2, üblich ist %3</translation>
    </message>
    <message>
        <source>%1 · does not fit: misfit %2, usual is %3</source>
        <translation>%1 · passt nicht: Abweichung %2, üblich ist %3</translation>
    </message>
    <message>
        <source>%1 · misfit %2</source>
        <translation>%1 · Abweichung %2</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>passt nicht</translation>
    </message>
    <message>
        <source>can be moved</source>
        <translation>verschiebbar</translation>
    </message>
    <message>
        <source>Cell %1 at (%2, %3, %4) mm ± %5 mm</source>
        <translation>Zelle %1 bei (%2; %3; %4) mm ± %5 mm</translation>
    </message>
    <message>
        <source>Cell %1 to cell %2: %3 mm ± %4 mm</source>
        <translation>Zelle %1 bis Zelle %2: %3 mm ± %4 mm</translation>
    </message>
    <message>
        <source>put by hand</source>
        <translation>von Hand gelegt</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlacePanel</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Which robot wears the skin?</source>
        <translation>Welcher Roboter trägt die Haut?</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>How did it stand in each pose?</source>
        <translation>Wie stand er in jeder Pose?</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>Which patch is to be placed?</source>
        <translation>Welches Hautstück soll eingeordnet werden?</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>Which link saw the same gravity?</source>
        <translation>Welches Glied hat dieselbe Schwerkraft gesehen?</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Was bekannt ist</translation>
    </message>
    <message>
        <source>What says where on the link it lies?</source>
        <translation>Was sagt, wo auf dem Glied es liegt?</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Where on the link can it lie?</source>
        <translation>Wo auf dem Glied kann es liegen?</translation>
    </message>
    <message>
        <source>Choose URDF…</source>
        <translation>URDF wählen…</translation>
    </message>
    <message>
        <source>Choose the robot&apos;s URDF</source>
        <translation>Das URDF des Roboters wählen</translation>
    </message>
    <message>
        <source>Package folder…</source>
        <translation>Paketordner…</translation>
    </message>
    <message>
        <source>Say in which folder a package of the robot is</source>
        <translation>Angeben, in welchem Ordner ein Paket des Roboters liegt</translation>
    </message>
    <message>
        <source>Where a URDF says package://NAME/…: the folder called NAME</source>
        <translation>Wo ein URDF package://NAME/… sagt: der Ordner namens NAME</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the robot</source>
        <translation>Den Roboter entfernen</translation>
    </message>
    <message>
        <source>Choose CSV…</source>
        <translation>CSV wählen…</translation>
    </message>
    <message>
        <source>Choose a table of joint angles</source>
        <translation>Eine Tabelle mit Gelenkwinkeln wählen</translation>
    </message>
    <message>
        <source>Pose in which the robot is drawn</source>
        <translation>Pose, in der der Roboter gezeichnet wird</translation>
    </message>
    <message>
        <source>Drawn in</source>
        <translation>Gezeichnet in</translation>
    </message>
    <message>
        <source>Patch that is placed</source>
        <translation>Hautstück, das eingeordnet wird</translation>
    </message>
    <message>
        <source>Links that the patch may be on</source>
        <translation>Glieder, auf denen das Hautstück liegen kann</translation>
    </message>
    <message>
        <source>Return or a click puts the patch on a link</source>
        <translation>Die Eingabetaste oder ein Klick legt das Hautstück auf ein Glied</translation>
    </message>
    <message>
        <source>Any link of the robot</source>
        <translation>Jedes Glied des Roboters</translation>
    </message>
    <message>
        <source>On link</source>
        <translation>Auf Glied</translation>
    </message>
    <message>
        <source>Its back lies on the link&apos;s surface</source>
        <translation>Rückseite liegt auf dem Glied</translation>
    </message>
    <message>
        <source>Known points and distances</source>
        <translation>Bekannte Punkte und Abstände</translation>
    </message>
    <message>
        <source>Remove the picked point or distance</source>
        <translation>Den gewählten Punkt oder Abstand entfernen</translation>
    </message>
    <message>
        <source>Cell at the known point</source>
        <translation>Zelle am bekannten Punkt</translation>
    </message>
    <message>
        <source>x of the point in the link&apos;s frame</source>
        <translation>x des Punkts im Koordinatensystem des Glieds</translation>
    </message>
    <message>
        <source>y of the point in the link&apos;s frame</source>
        <translation>y des Punkts im Koordinatensystem des Glieds</translation>
    </message>
    <message>
        <source>z of the point in the link&apos;s frame</source>
        <translation>z des Punkts im Koordinatensystem des Glieds</translation>
    </message>
    <message>
        <source>Uncertainty of the point, 1 sigma</source>
        <translation>Unsicherheit des Punkts, 1 Sigma</translation>
    </message>
    <message>
        <source>Pick in 3D</source>
        <translation>In 3D wählen</translation>
    </message>
    <message>
        <source>Pick the point on the robot</source>
        <translation>Den Punkt am Roboter wählen</translation>
    </message>
    <message>
        <source>The next click on the robot fills in x, y and z</source>
        <translation>Der nächste Klick auf den Roboter füllt x, y und z aus</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add the known point</source>
        <translation>Den bekannten Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>±</source>
        <translation>±</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Cell of this patch</source>
        <translation>Zelle dieses Hautstücks</translation>
    </message>
    <message>
        <source>Cell of another patch on the same link</source>
        <translation>Zelle eines anderen Hautstücks auf demselben Glied</translation>
    </message>
    <message>
        <source>Measured distance of the two cells</source>
        <translation>Gemessener Abstand der beiden Zellen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Uncertainty of the distance, 1 sigma</source>
        <translation>Unsicherheit des Abstands, 1 Sigma</translation>
    </message>
    <message>
        <source>Add distance</source>
        <translation>Abstand hinzufügen</translation>
    </message>
    <message>
        <source>Add the measured distance</source>
        <translation>Den gemessenen Abstand hinzufügen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>is</source>
        <translation>ist</translation>
    </message>
    <message>
        <source>Places that fit, the best first</source>
        <translation>Plätze, die passen, der beste zuerst</translation>
    </message>
    <message>
        <source>Pointing at a place shows it; Return or a click takes it</source>
        <translation>Zeigen auf einen Platz führt ihn vor; die Eingabetaste oder ein Klick übernimmt ihn</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Take the patch away from its place</source>
        <translation>Das Hautstück von seinem Platz wegnehmen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Nothing says where on the link the patch lies: use the surface, or add a point.</source>
        <translation>Nichts sagt, wo auf dem Glied das Hautstück liegt: die Oberfläche verwenden oder einen Punkt hinzufügen.</translation>
    </message>
    <message>
        <source>Nothing describes the surface of this link; points and distances can say where the patch lies.</source>
        <translation>Nichts beschreibt die Oberfläche dieses Glieds; Punkte und Abstände können sagen, wo das Hautstück liegt.</translation>
    </message>
    <message>
        <source>The robot&apos;s description; a file can also be dropped onto the window</source>
        <translation>Die Beschreibung des Roboters; eine Datei lässt sich auch auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>A line for each pose, a column for each joint, with its unit</source>
        <translation>Eine Zeile für jede Pose, eine Spalte für jedes Gelenk, mit ihrer Einheit</translation>
    </message>
    <message>
        <source>Choose the robot first: its joints have the names of the columns</source>
        <translation>Zuerst den Roboter wählen: Seine Gelenke geben den Spalten ihre Namen</translation>
    </message>
    <message>
        <source>Joint angles of the poses</source>
        <translation>Gelenkwinkel der Posen</translation>
    </message>
    <message>
        <source>Type angles, or paste a block of them from a spreadsheet; an empty cell is an angle that is not known</source>
        <translation>Winkel eintippen oder einen Block aus einer Tabellenkalkulation einfügen; eine leere Zelle ist ein Winkel, der nicht bekannt ist</translation>
    </message>
    <message>
        <source>Move by hand</source>
        <translation>Von Hand bewegen</translation>
    </message>
    <message>
        <source>Move the patch over the link by keys</source>
        <translation>Das Hautstück mit Tasten über das Glied bewegen</translation>
    </message>
    <message>
        <source>Look closely</source>
        <translation>Nah ansehen</translation>
    </message>
    <message>
        <source>Look closely at the patch on the robot</source>
        <translation>Das Hautstück am Roboter nah ansehen</translation>
    </message>
    <message>
        <source>The picture shows the cells of the patch with their numbers</source>
        <translation>Das Bild zeigt die Zellen des Hautstücks mit ihren Nummern</translation>
    </message>
    <message>
        <source>In the picture the mouse pulls the patch over the link at any time; this is for the keyboard</source>
        <translation>Im Bild zieht die Maus das Hautstück jederzeit über das Glied; dies ist für die Tastatur</translation>
    </message>
    <message>
        <source>A patch is moved over the surface of its link, which has to be known and used</source>
        <translation>Ein Hautstück wird über die Oberfläche seines Glieds bewegt, die bekannt sein und benutzt werden muss</translation>
    </message>
    <message>
        <source>The robot&apos;s description holds no surface of this link</source>
        <translation>Die Beschreibung des Roboters enthält keine Oberfläche dieses Glieds</translation>
    </message>
    <message>
        <source>Pick a point or a distance in the list first</source>
        <translation>Zuerst einen Punkt oder Abstand in der Liste wählen</translation>
    </message>
    <message>
        <source>Type the measured distance first</source>
        <translation>Zuerst den gemessenen Abstand eingeben</translation>
    </message>
    <message>
        <source>The patch is drawn once its place is known</source>
        <translation>Das Hautstück wird gezeichnet, sobald sein Platz bekannt ist</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlacePresenter</name>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>This point is on link %1, and the patch on %2: pick a point of that link.</source>
        <translation>Dieser Punkt liegt auf Glied %1 und das Hautstück auf %2: einen Punkt dieses Glieds wählen.</translation>
    </message>
    <message>
        <source>%1 has no line for any pose of this session.</source>
        <translation>%1 hat für keine Pose dieser Sitzung eine Zeile.</translation>
    </message>
    <message>
        <source>read the joint angles of %1</source>
        <translation>Gelenkwinkel aus %1 lesen</translation>
    </message>
    <message>
        <source>Choose the robot&apos;s URDF</source>
        <translation>Das URDF des Roboters wählen</translation>
    </message>
    <message>
        <source>Robots (*.urdf *.xml);;All files (*)</source>
        <translation>Roboter (*.urdf *.xml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The folder of a package</source>
        <translation>Der Ordner eines Pakets</translation>
    </message>
    <message>
        <source>Choose a table of joint angles</source>
        <translation>Eine Tabelle mit Gelenkwinkeln wählen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.tsv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose the robot first: its joints have the names of the columns.</source>
        <translation>Zuerst den Roboter wählen: Seine Gelenke geben den Spalten ihre Namen.</translation>
    </message>
    <message>
        <source>There is no skin yet.</source>
        <translation>Noch gibt es keine Haut.</translation>
    </message>
    <message>
        <source>A calibration is open: it holds the result, not the poses.</source>
        <translation>Eine Kalibrierung ist geöffnet: Sie enthält das Ergebnis, nicht die Posen.</translation>
    </message>
    <message>
        <source>The robot has no link %1, on which the patch was placed: choose another one, or the robot that it belongs to.</source>
        <translation>Der Roboter hat kein Glied %1, auf dem das Hautstück eingeordnet wurde: ein anderes wählen, oder den Roboter, zu dem es gehört.</translation>
    </message>
    <message>
        <source>place the patch</source>
        <translation>Hautstück einordnen</translation>
    </message>
    <message>
        <source>move the patch by hand</source>
        <translation>Hautstück von Hand bewegen</translation>
    </message>
    <message>
        <source>set joint angles of %1 poses</source>
        <translation>Gelenkwinkel von %1 Posen setzen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlaceSearch</name>
    <message>
        <source>Of a patch this large only some cells are placed, and %1 known points are of others: give points of other cells.</source>
        <translation>Von einem so großen Hautstück werden nur einige Zellen eingeordnet, und %1 bekannte Punkte gehören zu anderen: Punkte anderer Zellen angeben.</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlaceSentences</name>
    <message>
        <source>%1, %2 links, from %3.</source>
        <translation>%1, %2 Glieder, aus %3.</translation>
    </message>
    <message>
        <source>Not chosen yet.</source>
        <translation>Noch nicht gewählt.</translation>
    </message>
    <message>
        <source>No pose has joint angles, so that no link can be told. A link can be chosen all the same.</source>
        <translation>Keine Pose hat Gelenkwinkel, so dass sich kein Glied bestimmen lässt. Ein Glied lässt sich trotzdem wählen.</translation>
    </message>
    <message>
        <source>%1 of %2 poses have joint angles.</source>
        <translation>%1 von %2 Posen haben Gelenkwinkel.</translation>
    </message>
    <message>
        <source>This patch saw gravity in no pose that has joint angles.</source>
        <translation>Dieses Hautstück hat in keiner Pose mit Gelenkwinkeln Schwerkraft gesehen.</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>All joints at 0</source>
        <translation>Alle Gelenke auf 0</translation>
    </message>
    <message>
        <source>Cell %1 alone</source>
        <translation>Zelle %1 allein</translation>
    </message>
    <message>
        <source>Patch of cell %1, %2 cells</source>
        <translation>Hautstück der Zelle %1, %2 Zellen</translation>
    </message>
    <message>
        <source>Pull it by the mouse; or arrow keys slide it by 1 mm, Page Up and Page Down turn it by 1°, with Shift by ten times as much. Return lays it there, Escape leaves it where it was.</source>
        <translation>Mit der Maus ziehen; oder die Pfeiltasten schieben es um 1 mm, Bild auf und Bild ab drehen es um 1°, mit der Umschalttaste um das Zehnfache. Die Eingabetaste legt es dort ab, Esc lässt es, wo es war.</translation>
    </message>
</context>
<context>
    <name>hexoderm::Placing</name>
    <message>
        <source>The file has changed since the robot was chosen: look whether the places still hold.</source>
        <translation>Die Datei hat sich geändert, seit der Roboter gewählt wurde: nachsehen, ob die Plätze noch stimmen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlotData</name>
    <message>
        <source>number of the cell</source>
        <translation>Nummer der Zelle</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>die Fläche</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlotPicture</name>
    <message>
        <source>as predicted</source>
        <translation>wie erwartet</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlotPointing</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Verbindung %1</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>%1 cells from %2 to %3</source>
        <translation>%1 Zellen von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 links from %2 to %3</source>
        <translation>%1 Verbindungen von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>hexoderm::PlotView</name>
    <message>
        <source>What is plotted</source>
        <translation>Wovon das Diagramm handelt</translation>
    </message>
    <message>
        <source>Figure along the plot</source>
        <translation>Kennwert nach rechts</translation>
    </message>
    <message>
        <source>Figure up the plot</source>
        <translation>Kennwert nach oben</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>how many (histogram)</source>
        <translation>Anzahl (Histogramm)</translation>
    </message>
    <message>
        <source>The plot appears here as soon as a skin is open.</source>
        <translation>Das Diagramm erscheint hier, sobald eine Haut geöffnet ist.</translation>
    </message>
    <message>
        <source>Nothing has both figures.</source>
        <translation>Nichts hat beide Kennwerte.</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>%1 marked (Esc: none)</source>
        <translation>%1 markiert (Esc: keine)</translation>
    </message>
    <message>
        <source>%1 without a value</source>
        <translation>%1 ohne Wert</translation>
    </message>
    <message>
        <source>Plot of the figures of cells and links</source>
        <translation>Diagramm der Kennwerte von Zellen und Verbindungen</translation>
    </message>
    <message>
        <source>Drag a rectangle to mark cells in all views, or use the arrow keys with Shift</source>
        <translation>Ein Rechteck ziehen, um Zellen in allen Ansichten zu markieren, oder mit Umschalt die Pfeiltasten benutzen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PoseTable</name>
    <message>
        <source>Pose %1 is disabled: it is kept, but not used.</source>
        <translation>Pose %1 wird nicht benutzt, bleibt aber erhalten.</translation>
    </message>
    <message>
        <source>%1 cells gave no reading in this pose.</source>
        <translation>%1 Zellen gaben in dieser Pose keinen Messwert.</translation>
    </message>
    <message>
        <source>There is no earlier pose to compare it with.</source>
        <translation>Es gibt keine frühere Pose zum Vergleichen.</translation>
    </message>
    <message>
        <source>Pose %1, used</source>
        <translation>Pose %1, benutzt</translation>
    </message>
    <message>
        <source>Pose %1, disabled</source>
        <translation>Pose %1, nicht benutzt</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the pose; a check mark if it is used, a dash if it is disabled</source>
        <translation>Nummer der Pose; ein Haken, wenn sie benutzt wird, sonst ein Strich</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What the pose is called</source>
        <translation>Wie die Pose heißt</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells that gave a reading, of all cells</source>
        <translation>Zellen, die einen Messwert gaben, von allen</translation>
    </message>
    <message>
        <source>Noise mg</source>
        <translation>Rausch. mg</translation>
    </message>
    <message>
        <source>Standard deviation of the mean readings, rms over the cells</source>
        <translation>Standardabweichung der gemittelten Messwerte, Effektivwert über die Zellen</translation>
    </message>
    <message>
        <source>New by</source>
        <translation>Neu um</translation>
    </message>
    <message>
        <source>Angle to the nearest direction of gravity seen in an earlier pose</source>
        <translation>Winkel zur nächsten Schwerkraftrichtung einer früheren Pose</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>How badly the pose fits the reconstruction: rms over the links</source>
        <translation>Wie schlecht die Pose zum Ergebnis passt: Effektivwert über die Verbindungen</translation>
    </message>
</context>
<context>
    <name>hexoderm::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Groups of preferences</source>
        <translation>Gruppen von Einstellungen</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>All preferences on all pages become as they were at the first start</source>
        <translation>Alle Einstellungen auf allen Seiten werden wie beim ersten Start</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light or dark, or what the system asks for.</source>
        <translation>Hell oder dunkel, oder wie das System.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Sch&amp;riftgröße</translation>
    </message>
    <message>
        <source>Relative to the text size that the system asks for.</source>
        <translation>Bezogen auf die Schriftgröße des Systems.</translation>
    </message>
    <message>
        <source>&amp;Less motion</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Views jump to where they would otherwise glide, and nothing moves by itself.</source>
        <translation>Ansichten springen, wohin sie sonst gleiten, und nichts bewegt sich von selbst.</translation>
    </message>
    <message>
        <source>&amp;Draw without the graphics card</source>
        <translation>&amp;Ohne Grafikkarte zeichnen</translation>
    </message>
    <message>
        <source>For remote desktops and faulty drivers: OpenGL by the processor, from the next start on. Slower, and enough for thousands of cells.</source>
        <translation>Für Fernzugriff und fehlerhafte Treiber: OpenGL im Prozessor, ab dem nächsten Start. Langsamer, aber genug für Tausende von Zellen.</translation>
    </message>
    <message>
        <source>Lengths are in millimetres and angles in degrees on screen; files hold metres and radians.</source>
        <translation>Auf dem Bildschirm sind Längen in Millimetern und Winkel in Grad; Dateien enthalten Meter und Radiant.</translation>
    </message>
    <message>
        <source>&amp;Sound when a pose is captured</source>
        <translation>&amp;Ton, wenn eine Pose aufgenommen ist</translation>
    </message>
    <message>
        <source>So that you know without looking at the screen.</source>
        <translation>Damit es auch ohne Blick auf den Bildschirm klar ist.</translation>
    </message>
    <message>
        <source>Largest s&amp;catter</source>
        <translation>Größte St&amp;reuung</translation>
    </message>
    <message>
        <source>The part counts as still when its cells scatter by less than this beyond their own noise; 30 mg is a hand that holds it. A robot&apos;s arm allows less.</source>
        <translation>Das Teil gilt als ruhig, wenn seine Zellen um weniger als dies über ihr Rauschen hinaus streuen; 30 mg ist eine Hand, die es hält. Ein Roboterarm erlaubt weniger.</translation>
    </message>
    <message>
        <source>Largest &amp;turn</source>
        <translation>Größte &amp;Drehung</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>The part counts as still when it turns more slowly than this.</source>
        <translation>Das Teil gilt als ruhig, wenn es sich langsamer als dies dreht.</translation>
    </message>
    <message>
        <source>&amp;Hold for</source>
        <translation>&amp;Halten für</translation>
    </message>
    <message>
        <source>How long it must be still before samples are taken.</source>
        <translation>Wie lange es ruhig sein muss, bevor gemessen wird.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Samples of &amp;each cell</source>
        <translation>Messwerte &amp;je Zelle</translation>
    </message>
    <message>
        <source>Automatic takes 100, or what slower cells send in 0.75 s. More take longer and make the mean steadier.</source>
        <translation>Automatisch nimmt 100, oder was langsamere Zellen in 0,75 s senden. Mehr dauert länger und macht das Mittel ruhiger.</translation>
    </message>
    <message>
        <source>Limits act from the next connection on.</source>
        <translation>Grenzen wirken ab der nächsten Verbindung.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>&amp;Solver</source>
        <translation>&amp;Berechnung</translation>
    </message>
    <message>
        <source>Global</source>
        <translation>Global</translation>
    </message>
    <message>
        <source>Tree, as in the paper</source>
        <translation>Baum, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Global uses all links and poses at once and says how sure it is; the tree goes from cell to cell along shortest paths.</source>
        <translation>Global benutzt alle Verbindungen und Posen zugleich und sagt, wie sicher es ist; der Baum geht auf kürzesten Wegen von Zelle zu Zelle.</translation>
    </message>
    <message>
        <source>&amp;Gap between cells</source>
        <translation>&amp;Spalt zwischen Zellen</translation>
    </message>
    <message>
        <source>Fit: found from closed loops</source>
        <translation>Anpassen: aus geschlossenen Schleifen</translation>
    </message>
    <message>
        <source>Arc: the mould stretches along an arc</source>
        <translation>Bogen: Die Einbettung dehnt sich entlang eines Bogens</translation>
    </message>
    <message>
        <source>Pivot: the gap bends in one point</source>
        <translation>Gelenk: Der Spalt knickt in einem Punkt</translation>
    </message>
    <message>
        <source>How the mould gives way between two cells. Fit estimates it from each patch; a patch without loops can&apos;t tell, and the stated uncertainty says so.</source>
        <translation>Wie die Einbettung zwischen zwei Zellen nachgibt. Anpassen schätzt es aus jedem Hautstück; ohne Schleifen geht das nicht, und die angegebene Unsicherheit sagt es.</translation>
    </message>
    <message>
        <source>Remove sensor &amp;offsets</source>
        <translation>&amp;Nullpunkte entfernen</translation>
    </message>
    <message>
        <source>Subtracts each cell&apos;s mean over the poses, which takes its sensor&apos;s offset away. Automatic does so where the poses are good enough for it.</source>
        <translation>Zieht das Mittel jeder Zelle über die Posen ab, was den Nullpunkt ihres Sensors entfernt. Automatisch tut das, wo die Posen dafür gut genug sind.</translation>
    </message>
    <message>
        <source>Support &amp;axes</source>
        <translation>Stütz&amp;achsen</translation>
    </message>
    <message>
        <source>Keep links nearly flat in directions that no pose has determined.</source>
        <translation>Hält Verbindungen fast flach in Richtungen, die keine Pose bestimmt hat.</translation>
    </message>
    <message>
        <source>&amp;Weights of the paths</source>
        <translation>&amp;Gewichte der Wege</translation>
    </message>
    <message>
        <source>Paper: by class</source>
        <translation>Aufsatz: nach Güte</translation>
    </message>
    <message>
        <source>By residual</source>
        <translation>Nach Restfehler</translation>
    </message>
    <message>
        <source>Which links the tree prefers: those of a good class, or those that fit well.</source>
        <translation>Welche Verbindungen der Baum bevorzugt: die von guter Güte oder die gut passenden.</translation>
    </message>
    <message>
        <source>&amp;Threshold of the classes</source>
        <translation>S&amp;chwelle der Güte</translation>
    </message>
    <message>
        <source>A direction counts as defined from this singular value on: 0.5 accepts poses 60° to 120° apart, 1 is the paper&apos;s.</source>
        <translation>Eine Richtung gilt ab diesem Singulärwert als bestimmt: 0,5 lässt Posen mit 60° bis 120° Abstand zu, 1 ist der Wert des Aufsatzes.</translation>
    </message>
    <message>
        <source>the folder of the last file</source>
        <translation>der Ordner der letzten Datei</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Where new sessions of a connected skin go unless another folder is chosen there.</source>
        <translation>Wohin neue Sitzungen einer verbundenen Haut kommen, wenn dort kein anderer Ordner gewählt wird.</translation>
    </message>
    <message>
        <source>&amp;Folder for sessions</source>
        <translation>&amp;Ordner für Sitzungen</translation>
    </message>
    <message>
        <source>Folder for sessions</source>
        <translation>Ordner für Sitzungen</translation>
    </message>
    <message>
        <source>A session that was not saved anywhere is kept beside the program&apos;s own data, and offered at the next start.</source>
        <translation>Eine nirgends gespeicherte Sitzung liegt bei den Daten des Programms und wird beim nächsten Start angeboten.</translation>
    </message>
    <message>
        <source>Changes act at once, except where it says otherwise.</source>
        <translation>Änderungen wirken sofort, wo nichts anderes steht.</translation>
    </message>
    <message>
        <source>From the next start on.</source>
        <translation>Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>S&amp;peak instructions</source>
        <translation>Anweisungen &amp;vorsprechen</translation>
    </message>
    <message>
        <source>For hands and eyes that are on the robot: what to do next is spoken when it changes, in the language of the window.</source>
        <translation>Für Hände und Augen, die am Roboter sind: Was als Nächstes zu tun ist, wird gesprochen, wenn es sich ändert, in der Sprache des Fensters.</translation>
    </message>
    <message>
        <source>Not available: %1</source>
        <translation>Nicht verfügbar: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::RangePopup</name>
    <message>
        <source>&amp;Fitted to what is shown</source>
        <translation>&amp;An das Gezeigte angepasst</translation>
    </message>
    <message>
        <source>F&amp;ixed:</source>
        <translation>&amp;Fest:</translation>
    </message>
    <message>
        <source>Lower end of the range</source>
        <translation>Unteres Ende des Bereichs</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Oberes Ende des Bereichs</translation>
    </message>
    <message>
        <source>The lower end must be below the upper one.</source>
        <translation>Das untere Ende muss unter dem oberen liegen.</translation>
    </message>
    <message>
        <source>Range of the colours</source>
        <translation>Bereich der Farben</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>&amp;Usual range, %1 to %2</source>
        <translation>&amp;Üblicher Bereich, %1 bis %2</translation>
    </message>
</context>
<context>
    <name>hexoderm::RecentFiles</name>
    <message>
        <source>The file is not there any more</source>
        <translation>Die Datei ist nicht mehr da</translation>
    </message>
    <message>
        <source>Its folder is not there: removed, or not connected</source>
        <translation>Ihr Ordner ist nicht da: entfernt oder nicht verbunden</translation>
    </message>
    <message>
        <source>You may not read this file</source>
        <translation>Diese Datei darf nicht gelesen werden</translation>
    </message>
    <message>
        <source>today, %1</source>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gestern, %1</translation>
    </message>
    <message>
        <source>Nothing was open yet</source>
        <translation>Noch war nichts offen</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Takes all files from this list; the files themselves stay</source>
        <translation>Nimmt alle Dateien von der Liste; die Dateien selbst bleiben</translation>
    </message>
</context>
<context>
    <name>hexoderm::RecentList</name>
    <message>
        <source>Sessions and calibrations that you open will be listed here.</source>
        <translation>Geöffnete Sitzungen und Kalibrierungen stehen später hier.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>%1. Del takes it from the list.</source>
        <translation>%1. Entf nimmt es von der Liste.</translation>
    </message>
    <message>
        <source>Take it from this list; the file itself stays</source>
        <translation>Von der Liste nehmen; die Datei selbst bleibt</translation>
    </message>
    <message>
        <source>Take %1 from the list</source>
        <translation>%1 von der Liste nehmen</translation>
    </message>
</context>
<context>
    <name>hexoderm::RecentSessions</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
</context>
<context>
    <name>hexoderm::RecoveryList</name>
    <message>
        <source>Sessions that were not saved</source>
        <translation>Nicht gespeicherte Sitzungen</translation>
    </message>
    <message>
        <source>Discarded; it is kept for %1 days.</source>
        <translation>Verworfen; sie bleibt %1 Tage aufgehoben.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take the session back</source>
        <translation>Die Sitzung zurückholen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Open it and go on where it ended</source>
        <translation>Öffnen und weitermachen, wo sie aufhörte</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Put it away; it can be taken back for %1 days</source>
        <translation>Weglegen; %1 Tage lang lässt sie sich zurückholen</translation>
    </message>
</context>
<context>
    <name>hexoderm::ReportPage</name>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Hexoderm calibration report</source>
        <translation>Hexoderm-Kalibrierbericht</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>links used</source>
        <translation>Verbindungen benutzt</translation>
    </message>
    <message>
        <source>patches</source>
        <translation>Hautstücke</translation>
    </message>
    <message>
        <source>poses used</source>
        <translation>Posen benutzt</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>position, worst cell, 95 %</source>
        <translation>Ort, schlechteste Zelle, 95 %</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>orientation, worst cell, 95 %</source>
        <translation>Orientierung, schlechteste Zelle, 95 %</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>None: nothing about topology, links, cells and poses stood out.</source>
        <translation>Keine: An Topologie, Verbindungen, Zellen und Posen fiel nichts auf.</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>No poses were taken.</source>
        <translation>Es wurden keine Posen aufgenommen.</translation>
    </message>
    <message>
        <source>used</source>
        <translation>benutzt</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Noise mg</source>
        <translation>Rauschen mg</translation>
    </message>
    <message>
        <source>New by</source>
        <translation>Neu um</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>used, in tree</source>
        <translation>benutzt, im Baum</translation>
    </message>
    <message>
        <source>muted: %1</source>
        <translation>ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verwindung</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Links with the largest residuals</source>
        <translation>Verbindungen mit den größten Restfehlern</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>through its links</source>
        <translation>über ihre Verbindungen</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>Body part</source>
        <translation>Körperteil</translation>
    </message>
    <message>
        <source>x mm</source>
        <translation>x mm</translation>
    </message>
    <message>
        <source>y mm</source>
        <translation>y mm</translation>
    </message>
    <message>
        <source>z mm</source>
        <translation>z mm</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>± turn</source>
        <translation>± Drehung</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Eingeordnet</translation>
    </message>
    <message>
        <source>%1 more cells are in the calibration file and in the exported tables.</source>
        <translation>%1 weitere Zellen stehen in der Kalibrierdatei und in den exportierten Tabellen.</translation>
    </message>
    <message>
        <source>All links</source>
        <translation>Alle Verbindungen</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Gap model</source>
        <translation>Spaltmodell</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Zentrierung</translation>
    </message>
    <message>
        <source>Support axes</source>
        <translation>Stützachsen</translation>
    </message>
    <message>
        <source>Link weights</source>
        <translation>Gewichte der Verbindungen</translation>
    </message>
    <message>
        <source>A direction counts as defined from</source>
        <translation>Eine Richtung gilt als bestimmt ab</translation>
    </message>
    <message>
        <source>Limits of bend, twist, yaw</source>
        <translation>Grenzen für Biegung, Verwindung, Gieren</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Limit of misfit</source>
        <translation>Grenze der Abweichung</translation>
    </message>
    <message>
        <source>%1 standard deviations</source>
        <translation>%1 Standardabweichungen</translation>
    </message>
    <message>
        <source>Cells left out</source>
        <translation>Weggelassene Zellen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>Woher es stammt</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Cell model</source>
        <translation>Zellmodell</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Solved in</source>
        <translation>Gelöst in</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>SIMULATED: nothing real was measured</source>
        <translation>SIMULIERT: Es wurde nichts Wirkliches gemessen</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bedient von</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>±%1 mm and ±%2</source>
        <translation>±%1 mm und ±%2</translation>
    </message>
    <message>
        <source>With a probability of 95 %, each measured cell is at most %1 mm and %2 from where this report says, along or about any one axis, seen from the origin cell of its patch.</source>
        <translation>Mit einer Wahrscheinlichkeit von 95 % liegt jede gemessene Zelle entlang oder um jede einzelne Achse höchstens %1 mm und %2 neben dem, was dieser Bericht nennt, von der Ursprungszelle ihres Hautstücks aus gesehen.</translation>
    </message>
    <message>
        <source>A good calibration knows every cell to %1, and this one does.</source>
        <translation>Eine gute Kalibrierung kennt jede Zelle auf %1 genau, und diese tut es.</translation>
    </message>
    <message>
        <source>A good calibration knows every cell to %1; this one is coarser, and serves where touch need not be located more finely.</source>
        <translation>Eine gute Kalibrierung kennt jede Zelle auf %1 genau; diese ist gröber und genügt, wo Berührungen nicht feiner verortet werden müssen.</translation>
    </message>
    <message>
        <source>Robot software can use the places of the cells; how exact they are, this calibration does not state.</source>
        <translation>Robotersoftware kann die Orte der Zellen verwenden; wie genau sie sind, nennt diese Kalibrierung nicht.</translation>
    </message>
    <message>
        <source>The places of the cells are a first guess: what was measured does not determine them yet. They should not be used.</source>
        <translation>Die Orte der Zellen sind eine erste Schätzung: Was gemessen wurde, bestimmt sie noch nicht. Sie sollten nicht verwendet werden.</translation>
    </message>
    <message>
        <source>Something is broken or missing, as the findings say. The places of the cells should not be used.</source>
        <translation>Etwas ist defekt oder fehlt, wie die Befunde sagen. Die Orte der Zellen sollten nicht verwendet werden.</translation>
    </message>
    <message>
        <source>Shape and its uncertainty</source>
        <translation>Form und ihre Unsicherheit</translation>
    </message>
    <message>
        <source>%1 smaller patches are not drawn.</source>
        <translation>%1 kleinere Hautstücke sind nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Patch %1: cell %2 alone</source>
        <translation>Hautstück %1: Zelle %2 allein</translation>
    </message>
    <message>
        <source>Patch %1, of cell %2: %3 cells</source>
        <translation>Hautstück %1, der Zelle %2: %3 Zellen</translation>
    </message>
    <message>
        <source>Thick outline: cell %1, which is known least well (±%2 mm).</source>
        <translation>Dicker Umriss: Zelle %1, die am ungenauesten bekannt ist (±%2 mm).</translation>
    </message>
    <message>
        <source>Ring: cell %1, the origin of the patch&apos;s frame, whose axes are at the lower right.</source>
        <translation>Ring: Zelle %1, der Ursprung des Koordinatensystems des Hautstücks, dessen Achsen unten rechts stehen.</translation>
    </message>
    <message>
        <source>Hatched: placed through its links, for it has no readings of its own that could be used.</source>
        <translation>Schraffiert: über ihre Verbindungen verortet, denn sie hat keine brauchbaren eigenen Messwerte.</translation>
    </message>
    <message>
        <source>White: this calibration states no uncertainties.</source>
        <translation>Weiß: Diese Kalibrierung nennt keine Unsicherheiten.</translation>
    </message>
    <message>
        <source>Grey: seen from behind.</source>
        <translation>Grau: von hinten gesehen.</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>good: up to %1 mm</source>
        <translation>gut: bis %1 mm</translation>
    </message>
    <message>
        <source>uncertainty of the orientation (95 %), °</source>
        <translation>Unsicherheit der Orientierung (95 %), °</translation>
    </message>
    <message>
        <source>good: up to %1</source>
        <translation>gut: bis %1</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>How far the two ends of a link disagree about gravity</source>
        <translation>Wie weit die beiden Enden einer Verbindung über die Schwerkraft uneins sind</translation>
    </message>
    <message>
        <source>residual, rms over the poses, °</source>
        <translation>Restfehler, Effektivwert über die Posen, °</translation>
    </message>
    <message>
        <source>How exactly the poses determine a link</source>
        <translation>Wie genau die Posen eine Verbindung bestimmen</translation>
    </message>
    <message>
        <source>predicted deviation about the worst axis, °</source>
        <translation>vorhergesagte Abweichung um die schlechteste Achse, °</translation>
    </message>
    <message>
        <source>Picture: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Überprüfung</translation>
    </message>
    <message>
        <source>A pose that was held out</source>
        <translation>Eine zurückgehaltene Pose</translation>
    </message>
    <message>
        <source>a pose that was held out</source>
        <translation>eine zurückgehaltene Pose</translation>
    </message>
    <message>
        <source>Closed loops</source>
        <translation>Geschlossene Schleifen</translation>
    </message>
    <message>
        <source>closed loops</source>
        <translation>geschlossene Schleifen</translation>
    </message>
    <message>
        <source>The surface that the cells lie on</source>
        <translation>Die Fläche, auf der die Zellen liegen</translation>
    </message>
    <message>
        <source>a fitted surface</source>
        <translation>eine angepasste Fläche</translation>
    </message>
    <message>
        <source>Comparison with %1</source>
        <translation>Vergleich mit %1</translation>
    </message>
    <message>
        <source>a comparison with an earlier calibration</source>
        <translation>ein Vergleich mit einer früheren Kalibrierung</translation>
    </message>
    <message>
        <source>Does %1 still hold?</source>
        <translation>Stimmt %1 noch?</translation>
    </message>
    <message>
        <source>a check of an old calibration</source>
        <translation>eine Prüfung einer alten Kalibrierung</translation>
    </message>
    <message>
        <source>Not made for this report: %1.</source>
        <translation>Für diesen Bericht nicht vorgenommen: %1.</translation>
    </message>
    <message>
        <source>surface of the link</source>
        <translation>Oberfläche des Glieds</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 distances</source>
        <translation>%1 Abstände</translation>
    </message>
    <message>
        <source>only the link is known</source>
        <translation>nur das Glied ist bekannt</translation>
    </message>
    <message>
        <source>Place on the robot</source>
        <translation>Ort am Roboter</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Roboter: %1</translation>
    </message>
    <message>
        <source>Where the frame of each patch, that of its origin cell, lies in the frame of its link: position in mm, turn as roll, pitch and yaw as in a URDF; ± at 95 %, along or about the worst axis.</source>
        <translation>Wo das Koordinatensystem jedes Hautstücks, das seiner Ursprungszelle, in dem seines Glieds liegt: Ort in mm, Drehung als Rollen, Nicken und Gieren wie in einer URDF; ± mit 95 %, entlang oder um die schlechteste Achse.</translation>
    </message>
    <message>
        <source>Patch of cell</source>
        <translation>Hautstück der Zelle</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Found by</source>
        <translation>Gefunden durch</translation>
    </message>
    <message>
        <source>The %1 cells that are known least well</source>
        <translation>Die %1 Zellen, die am ungenauesten bekannt sind</translation>
    </message>
    <message>
        <source>Position of the cell&apos;s centre in the frame of its patch&apos;s origin cell; ± at 95 % along or about the worst axis, relative to the origin, and as a place in the shape as a whole.</source>
        <translation>Ort der Zellmitte im Koordinatensystem der Ursprungszelle ihres Hautstücks; ± mit 95 % entlang oder um die schlechteste Achse, relativ zum Ursprung und als Ort in der Form als Ganzes.</translation>
    </message>
    <message>
        <source>Shape ± mm</source>
        <translation>Form ± mm</translation>
    </message>
    <message>
        <source>Shape ± turn</source>
        <translation>Form ± Drehung</translation>
    </message>
    <message>
        <source>All %1 links are in the calibration file and in the exported tables.</source>
        <translation>Alle %1 Verbindungen stehen in der Kalibrierungsdatei und in den exportierten Tabellen.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Gap share, patch of cell %1</source>
        <translation>Spaltanteil, Hautstück der Zelle %1</translation>
    </message>
    <message>
        <source>%1 ± %2 (1 sigma)</source>
        <translation>%1 ± %2 (1 Sigma)</translation>
    </message>
    <message>
        <source>How well the places of the cells are known, and the colours of the pictures above</source>
        <translation>Wie genau die Orte der Zellen bekannt sind, und die Farben der Bilder oben</translation>
    </message>
    <message>
        <source>How well the orientations of the cells are known</source>
        <translation>Wie genau die Orientierungen der Zellen bekannt sind</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>patch</source>
        <translation>Hautstück</translation>
    </message>
    <message>
        <source>Which way was up in each pose, as the largest patch saw it; rings of 30°, 60° and 90°</source>
        <translation>Wo in jeder Pose oben war, wie das größte Hautstück es sah; Ringe von 30°, 60° und 90°</translation>
    </message>
    <message>
        <source>Residuals of the links in each pose: all, the middle half, the median</source>
        <translation>Restfehler der Verbindungen in jeder Pose: alle, die mittlere Hälfte, der Median</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>residual, °</source>
        <translation>Restfehler, °</translation>
    </message>
    <message>
        <source>Those with the largest figures; %1 more are in the window.</source>
        <translation>Die mit den größten Werten; %1 weitere stehen im Fenster.</translation>
    </message>
    <message>
        <source>Lot of accelerometers, patch of cell %1</source>
        <translation>Charge der Sensoren, Hautstück der Zelle %1</translation>
    </message>
    <message>
        <source>What was measured contradicts the model that the places of the cells follow from, so that this report can&apos;t say how far they are off. They should not be used.</source>
        <translation>Was gemessen wurde, widerspricht dem Modell, aus dem die Lage der Zellen folgt, sodass dieser Bericht nicht sagen kann, wie weit sie daneben liegen. Sie sollten nicht verwendet werden.</translation>
    </message>
</context>
<context>
    <name>hexoderm::ReportPatch</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>uncertainty of the place in the shape (95 %), mm</source>
        <translation>Unsicherheit des Ortes in der Form (95 %), mm</translation>
    </message>
    <message>
        <source>uncertainty of the position from the origin (95 %), mm</source>
        <translation>Unsicherheit des Ortes vom Ursprung aus (95 %), mm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Rechte Seite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linke Seite</translation>
    </message>
</context>
<context>
    <name>hexoderm::ReportPictures</name>
    <message>
        <source>Skin graph: the patches laid flat, their links by how well the poses determine them</source>
        <translation>Hautgraph: die Hautstücke flach ausgelegt, ihre Verbindungen danach, wie gut die Posen sie bestimmen</translation>
    </message>
</context>
<context>
    <name>hexoderm::ReportPlots</name>
    <message>
        <source>up where the origin faces</source>
        <translation>oben, wohin der Ursprung zeigt</translation>
    </message>
    <message>
        <source>up behind it</source>
        <translation>oben dahinter</translation>
    </message>
</context>
<context>
    <name>hexoderm::ReportTitleDialog</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bedient von</translation>
    </message>
    <message>
        <source>Title of the report</source>
        <translation>Titel des Berichts</translation>
    </message>
    <message>
        <source>What is the report about?</source>
        <translation>Worum geht es in dem Bericht?</translation>
    </message>
    <message>
        <source>Stands at the head of every report on %1, and is remembered for it. Empty fields are left out.</source>
        <translation>Steht am Kopf jedes Berichts über %1 und wird dafür gemerkt. Leere Felder werden weggelassen.</translation>
    </message>
    <message>
        <source>its name or serial number</source>
        <translation>sein Name oder seine Seriennummer</translation>
    </message>
    <message>
        <source>the body part that wears the skin</source>
        <translation>der Körperteil, der die Haut trägt</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>&amp;Teil</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>&amp;Bedient von</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notizen</translation>
    </message>
</context>
<context>
    <name>hexoderm::ResidualPlots</name>
    <message>
        <source>Residuals of each pose</source>
        <translation>Restfehler jeder Pose</translation>
    </message>
    <message>
        <source>Residuals of the links, the worst first</source>
        <translation>Restfehler der Verbindungen, die schlechtesten zuerst</translation>
    </message>
    <message>
        <source>Links by their residual beside the predicted deviation</source>
        <translation>Verbindungen nach Restfehler neben der erwarteten Abweichung</translation>
    </message>
    <message>
        <source>By pose, ° (box: half the links)</source>
        <translation>Je Pose, ° (Kasten: die Hälfte der Verbindungen)</translation>
    </message>
    <message>
        <source>By link, ° (○ predicted)</source>
        <translation>Je Verbindung, ° (○ erwartet)</translation>
    </message>
    <message>
        <source>Links by residual ÷ predicted</source>
        <translation>Verbindungen nach Restfehler ÷ erwartet</translation>
    </message>
    <message>
        <source>as predicted</source>
        <translation>wie erwartet</translation>
    </message>
    <message>
        <source>Click a link to pick it.</source>
        <translation>Ein Klick wählt die Verbindung.</translation>
    </message>
</context>
<context>
    <name>hexoderm::ResidualTable</name>
    <message>
        <source>%1, pose %2: %3</source>
        <translation>%1, Pose %2: %3</translation>
    </message>
    <message>
        <source>%1, all poses: %2</source>
        <translation>%1, alle Posen: %2</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Rms over the poses, degrees</source>
        <translation>Effektivwert über die Posen, Grad</translation>
    </message>
    <message>
        <source>Pose %1 is disabled: it is kept, but not used.</source>
        <translation>Pose %1 wird nicht benutzt, bleibt aber erhalten.</translation>
    </message>
    <message>
        <source>Pose %1 %2, degrees</source>
        <translation>Pose %1 %2, Grad</translation>
    </message>
</context>
<context>
    <name>hexoderm::ResidualView</name>
    <message>
        <source>Colours: residual from 0 to %1 degrees and more</source>
        <translation>Farben: Restfehler von 0 bis %1 Grad und mehr</translation>
    </message>
    <message>
        <source>Residual 0°</source>
        <translation>Restfehler 0°</translation>
    </message>
    <message>
        <source>≥ %1°</source>
        <translation>≥ %1°</translation>
    </message>
    <message>
        <source>Residuals per link and pose</source>
        <translation>Restfehler je Verbindung und Pose</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Every link in every pose, as numbers and colours</source>
        <translation>Jede Verbindung in jeder Pose, als Zahlen und Farben</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Residuals by pose, by link, and beside what was predicted</source>
        <translation>Restfehler je Pose, je Verbindung und neben dem Erwarteten</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::ResultFiles</name>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Writing the report %1</source>
        <translation>Der Bericht %1 wird geschrieben</translation>
    </message>
</context>
<context>
    <name>hexoderm::ResultTables</name>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
</context>
<context>
    <name>hexoderm::RobotView</name>
    <message>
        <source>The robot in three dimensions</source>
        <translation>Der Roboter in drei Dimensionen</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2, which is not available here. Links, places and points can still be chosen in the lists.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2, das hier nicht verfügbar ist. Glieder, Plätze und Punkte lassen sich trotzdem in den Listen wählen.</translation>
    </message>
</context>
<context>
    <name>hexoderm::ScaleLegend</name>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>all within the goal of %1</source>
        <translation>alle im Ziel von %1</translation>
    </message>
    <message>
        <source>none within the goal of %1</source>
        <translation>keine im Ziel von %1</translation>
    </message>
    <message>
        <source>less than %1: %2</source>
        <translation>weniger als %1: %2</translation>
    </message>
    <message>
        <source>more than %1: %2</source>
        <translation>mehr als %1: %2</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 bis %2: %3</translation>
    </message>
    <message>
        <source>range fixed</source>
        <translation>Bereich fest</translation>
    </message>
    <message>
        <source>usual range</source>
        <translation>üblicher Bereich</translation>
    </message>
    <message>
        <source>range fitted to what is shown</source>
        <translation>Bereich an das Gezeigte angepasst</translation>
    </message>
    <message>
        <source>from %1 to %2, %3</source>
        <translation>von %1 bis %2, %3</translation>
    </message>
    <message>
        <source>not known: %1</source>
        <translation>nicht bekannt: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::SessionFile</name>
    <message>
        <source>%1 is open already.</source>
        <translation>%1 ist schon offen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Recovered session</source>
        <translation>Wiederhergestellte Sitzung</translation>
    </message>
    <message>
        <source>Changes will not be kept in this file; save the session under another name. %1</source>
        <translation>Änderungen bleiben nicht in dieser Datei; die Sitzung unter anderem Namen speichern. %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Until it is saved, this session is kept in memory only. %1</source>
        <translation>Bis sie gespeichert ist, liegt diese Sitzung nur im Speicher. %1</translation>
    </message>
    <message>
        <source>Simulating a robot</source>
        <translation>Ein Roboter wird simuliert</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>Simulierter Roboter</translation>
    </message>
</context>
<context>
    <name>hexoderm::Speaker</name>
    <message>
        <source>This computer has no engine that speaks, or none that answers.</source>
        <translation>Dieser Rechner hat keine Sprachausgabe, oder sie antwortet nicht.</translation>
    </message>
    <message>
        <source>This computer&apos;s engine has no voice for %1.</source>
        <translation>Die Sprachausgabe dieses Rechners hat keine Stimme für %1.</translation>
    </message>
    <message>
        <source>This program was built without speech.</source>
        <translation>Dieses Programm wurde ohne Sprachausgabe gebaut.</translation>
    </message>
</context>
<context>
    <name>hexoderm::StepPanel</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>current</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>Step %1, %2: %3</source>
        <translation>Schritt %1, %2: %3</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>✓ Ready: %1</source>
        <translation>✓ Bereit: %1</translation>
    </message>
    <message>
        <source>■ Blocked: %1</source>
        <translation>■ Blockiert: %1</translation>
    </message>
    <message>
        <source>▲ Possible: %1</source>
        <translation>▲ Möglich: %1</translation>
    </message>
    <message>
        <source>… Waiting: %1</source>
        <translation>… Wartet: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::StillnessView</name>
    <message>
        <source>moving</source>
        <translation>bewegt</translation>
    </message>
    <message>
        <source>still</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>capturing</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>captured %1</source>
        <translation>%1 aufgenommen</translation>
    </message>
    <message>
        <source>starts over</source>
        <translation>beginnt neu</translation>
    </message>
    <message>
        <source>Stillness of the last ten seconds</source>
        <translation>Ruhe der letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>No readings: when a skin is connected, this shows how still it is held.</source>
        <translation>Keine Messwerte: Ist eine Haut verbunden, zeigt dies, wie still sie gehalten wird.</translation>
    </message>
    <message>
        <source>cell %1, picked</source>
        <translation>Zelle %1, gewählt</translation>
    </message>
    <message>
        <source>cell %1, which decides</source>
        <translation>Zelle %1, die entscheidet</translation>
    </message>
    <message>
        <source>%1 · x y z, deviation from its mean, last %2 s, limit %3 mg</source>
        <translation>%1 · x y z, Abweichung vom Mittel, letzte %2 s, Grenze %3 mg</translation>
    </message>
    <message>
        <source>ready again</source>
        <translation>wieder bereit</translation>
    </message>
</context>
<context>
    <name>hexoderm::SurfaceWords</name>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
</context>
<context>
    <name>hexoderm::UnsavedSessions</name>
    <message>
        <source>A session of %1 was not saved and can&apos;t be read: %2</source>
        <translation>Eine Sitzung von %1 wurde nicht gespeichert und lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>A session of %1 with %2 of %3 cells was not saved.</source>
        <translation>Eine Sitzung von %1 mit %2 von %3 Zellen wurde nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>hexoderm::Verification</name>
    <message>
        <source>Patch %1: %2</source>
        <translation>Hautstück %1: %2</translation>
    </message>
</context>
<context>
    <name>hexoderm::Verify</name>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>ID of the cell</source>
        <translation>ID der Zelle</translation>
    </message>
    <message>
        <source>Needs three poses besides the one that is held out, and there are %1: take another pose.</source>
        <translation>Braucht drei Posen außer der zurückgehaltenen, vorhanden sind %1: noch eine Pose aufnehmen.</translation>
    </message>
    <message>
        <source>In pose %1 no two joined cells can be compared.</source>
        <translation>In Pose %1 lassen sich keine zwei verbundenen Zellen vergleichen.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Worst: cell %1, %2.</source>
        <translation>Am schlechtesten: Zelle %1, %2.</translation>
    </message>
    <message>
        <source>As good as stated. %1</source>
        <translation>So gut wie angegeben. %1</translation>
    </message>
    <message>
        <source>Somewhat worse than stated. %1 %2</source>
        <translation>Etwas schlechter als angegeben. %1 %2</translation>
    </message>
    <message>
        <source>Far worse than stated: the part moved in this pose, or a cell is wrong. %1 %2</source>
        <translation>Weit schlechter als angegeben: Das Teil hat sich in dieser Pose bewegt, oder eine Zelle ist falsch. %1 %2</translation>
    </message>
    <message>
        <source>Error °</source>
        <translation>Fehler °</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>What the stated uncertainties lead one to expect, rms</source>
        <translation>Was nach den angegebenen Unsicherheiten zu erwarten ist, Effektivwert</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Cell and port of both ends</source>
        <translation>Zelle und Port beider Enden</translation>
    </message>
    <message>
        <source>Between what its two cells read, brought into one frame</source>
        <translation>Zwischen dem, was ihre beiden Zellen messen, in einem Koordinatensystem</translation>
    </message>
    <message>
        <source>No loop in any of the %1 patches: nothing closes that could be checked.</source>
        <translation>Keine Schleife in einem der %1 Hautstücke: Es schließt sich nichts, was sich prüfen ließe.</translation>
    </message>
    <message>
        <source>No loop in this patch: nothing closes that could be checked.</source>
        <translation>Keine Schleife in diesem Hautstück: Es schließt sich nichts, was sich prüfen ließe.</translation>
    </message>
    <message>
        <source>%1, %2 of its %3</source>
        <translation>%1, %2 ihrer %3</translation>
    </message>
    <message>
        <source>One open loop; its gap is %1.</source>
        <translation>Eine offene Schleife; ihre Lücke ist %1.</translation>
    </message>
    <message>
        <source>%1 open loops; the largest gap is %2.</source>
        <translation>%1 offene Schleifen; die größte Lücke ist %2.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 closed loops close: the largest is left open by %2, and a skin link may leave %3.</source>
        <translation>%1 geschlossene Schleifen schließen sich: Die größte bleibt um %2 offen, eine Hautverbindung darf %3 lassen.</translation>
    </message>
    <message>
        <source>Of %1 closed loops the largest is left open by %2, more than the %3 a skin link may leave: one of its links is wrong, or many err alike.</source>
        <translation>Von %1 geschlossenen Schleifen bleibt die größte um %2 offen, mehr als die %3, die eine Hautverbindung lassen darf: Eine ihrer Verbindungen ist falsch, oder viele haben denselben Fehler.</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>The two ports at which the loop is closed, or open</source>
        <translation>Die beiden Ports, an denen die Schleife geschlossen oder offen ist</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Closed by a link, or open between two free ports</source>
        <translation>Durch eine Verbindung geschlossen oder zwischen zwei freien Ports offen</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells of the loop</source>
        <translation>Zellen der Schleife</translation>
    </message>
    <message>
        <source>Gap mm</source>
        <translation>Lücke mm</translation>
    </message>
    <message>
        <source>Length of what is missing when the loop is walked round</source>
        <translation>Länge dessen, was nach einem Rundgang fehlt</translation>
    </message>
    <message>
        <source>X mm</source>
        <translation>X mm</translation>
    </message>
    <message>
        <source>The gap, in the patch&apos;s frame</source>
        <translation>Die Lücke, im Koordinatensystem des Hautstücks</translation>
    </message>
    <message>
        <source>Y mm</source>
        <translation>Y mm</translation>
    </message>
    <message>
        <source>Z mm</source>
        <translation>Z mm</translation>
    </message>
    <message>
        <source>Share %</source>
        <translation>Anteil %</translation>
    </message>
    <message>
        <source>The gap in per cent of the accumulated port vectors</source>
        <translation>Die Lücke in Prozent der aufsummierten Portvektoren</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>%1, half angle %2, radius %3 at its middle</source>
        <translation>%1, halber Winkel %2, Radius %3 in der Mitte</translation>
    </message>
    <message>
        <source>%1, radius %2</source>
        <translation>%1, Radius %2</translation>
    </message>
    <message>
        <source>%1: %2 cell centres lie within %3 (rms) of it; the worst is cell %4, %5.</source>
        <translation>%1: %2 Zellmitten liegen im Mittel (Effektivwert) %3 davon entfernt; am weitesten Zelle %4, %5.</translation>
    </message>
    <message>
        <source>That is within the ±%1 stated for positions (95 %).</source>
        <translation>Das liegt innerhalb der für Orte angegebenen ±%1 (95 %).</translation>
    </message>
    <message>
        <source>That is more than the ±%1 stated for positions (95 %): the part has another shape, or positions are worse than stated.</source>
        <translation>Das ist mehr als die für Orte angegebenen ±%1 (95 %): Das Teil hat eine andere Form, oder die Orte sind schlechter als angegeben.</translation>
    </message>
    <message>
        <source>Distance mm</source>
        <translation>Abstand mm</translation>
    </message>
    <message>
        <source>From the surface; positive outside of it</source>
        <translation>Von der Fläche; außerhalb positiv</translation>
    </message>
    <message>
        <source>%1 has no cell in common with this calibration.</source>
        <translation>%1 hat mit dieser Kalibrierung keine Zelle gemeinsam.</translation>
    </message>
    <message>
        <source>Against %1, after alignment: %2 and %3 rms over %4 cells.</source>
        <translation>Gegen %1, nach dem Ausrichten: %2 und %3 im Mittel (Effektivwert) über %4 Zellen.</translation>
    </message>
    <message>
        <source>%1 Neither of them states an uncertainty to compare with.</source>
        <translation>%1 Keine der beiden nennt eine Unsicherheit zum Vergleichen.</translation>
    </message>
    <message>
        <source>Within what was stated for 95 % of cells. %1 %2</source>
        <translation>Innerhalb dessen, was für 95 % der Zellen angegeben war. %1 %2</translation>
    </message>
    <message>
        <source>Further apart than what was stated for 95 % of cells. %1 %2</source>
        <translation>Weiter auseinander, als für 95 % der Zellen angegeben war. %1 %2</translation>
    </message>
    <message>
        <source>Moved mm</source>
        <translation>Versetzt mm</translation>
    </message>
    <message>
        <source>Distance between the two, after alignment</source>
        <translation>Abstand der beiden, nach dem Ausrichten</translation>
    </message>
    <message>
        <source>Stated mm</source>
        <translation>Angegeben mm</translation>
    </message>
    <message>
        <source>Standard deviation stated for that, of both together</source>
        <translation>Dafür angegebene Standardabweichung, beide zusammen</translation>
    </message>
    <message>
        <source>Turned °</source>
        <translation>Gedreht °</translation>
    </message>
    <message>
        <source>Angle between the two, after alignment</source>
        <translation>Winkel zwischen den beiden, nach dem Ausrichten</translation>
    </message>
    <message>
        <source>Stated °</source>
        <translation>Angegeben °</translation>
    </message>
    <message>
        <source>The part turned while it was read: %1 rad/s², of a still hand %2 are expected.</source>
        <translation>Das Teil drehte sich, während es gelesen wurde: %1 rad/s²; von einer ruhigen Hand werden %2 erwartet.</translation>
    </message>
    <message>
        <source>As good as stated, but a coarse check: with so few poses, a part that bent by less than about %1 would not show. %2</source>
        <translation>So gut wie angegeben, aber eine grobe Prüfung: Bei so wenigen Posen fiele ein Teil, das sich um weniger als etwa %1 verbogen hat, nicht auf. %2</translation>
    </message>
    <message>
        <source>No two cells lie in one patch both here and in %1: there is nothing to compare.</source>
        <translation>Keine zwei Zellen liegen sowohl hier als auch in %1 in einem Hautstück: Es gibt nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>Tilt °</source>
        <translation>Neigung °</translation>
    </message>
    <message>
        <source>Between the cell&apos;s face and the surface below it</source>
        <translation>Zwischen der Vorderseite der Zelle und der Fläche unter ihr</translation>
    </message>
    <message>
        <source>Cells %1 and %2</source>
        <translation>Zellen %1 und %2</translation>
    </message>
    <message>
        <source>%1: %2 measured, %3 estimated; no uncertainty is stated to compare them by.</source>
        <translation>%1: %2 gemessen, %3 geschätzt; keine Unsicherheit ist angegeben, an der sich das messen ließe.</translation>
    </message>
    <message>
        <source>%1: %2 measured, %3 estimated; they differ by %4, and %5 are expected (1 sigma).</source>
        <translation>%1: %2 gemessen, %3 geschätzt; der Unterschied ist %4, zu erwarten sind %5 (1 Sigma).</translation>
    </message>
    <message>
        <source>It agrees. %1 Cells %2 larger or smaller than in the cell model would show.</source>
        <translation>Es stimmt überein. %1 Zellen, die um %2 größer oder kleiner sind als im Zellmodell, würden auffallen.</translation>
    </message>
    <message>
        <source>It does not quite agree: measure again, and between two other cells. %1</source>
        <translation>Es stimmt nicht ganz überein: noch einmal messen, auch zwischen zwei anderen Zellen. %1</translation>
    </message>
    <message>
        <source>It contradicts the result. Check the size of the cells in the cell model, the numbering of the ports and the axes of the sensors; with fewer than three poses, take more. %1</source>
        <translation>Es widerspricht dem Ergebnis. Die Größe der Zellen im Zellmodell, die Nummern der Ports und die Achsen der Sensoren prüfen; bei weniger als drei Posen weitere aufnehmen. %1</translation>
    </message>
    <message>
        <source>Compared with %1: %2.</source>
        <translation>Verglichen mit %1: %2.</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>What became of the cell, with 1 sigma</source>
        <translation>Was aus der Zelle geworden ist, mit 1 Sigma</translation>
    </message>
    <message>
        <source>The turn that explains best what the cell reads</source>
        <translation>Die Drehung, die am besten erklärt, was die Zelle misst</translation>
    </message>
    <message>
        <source>Drift mg</source>
        <translation>Drift mg</translation>
    </message>
    <message>
        <source>The drift of its sensor&apos;s offset that explains best what the cell reads</source>
        <translation>Die Drift des Offsets ihres Sensors, die am besten erklärt, was die Zelle misst</translation>
    </message>
    <message>
        <source>Noticed from °</source>
        <translation>Fällt auf ab °</translation>
    </message>
    <message>
        <source>A turn by so much, about whatever axis, would be found in these poses with 95 %; no figure: a turn about some axis would not be</source>
        <translation>Eine Drehung um so viel, um welche Achse auch immer, würde in diesen Posen mit 95 % gefunden; keine Zahl: um irgendeine Achse nicht</translation>
    </message>
    <message>
        <source>The other %1 poses predict pose %2 to %3 (rms over %4 cells); %5 were expected.</source>
        <translation>Die anderen %1 Posen sagen Pose %2 auf %3 genau voraus (Effektivwert über %4 Zellen); erwartet waren %5.</translation>
    </message>
    <message>
        <source>Between the gravity the cell read and what the other cells and poses predict</source>
        <translation>Zwischen der Schwerkraft, die die Zelle maß, und dem, was die anderen Zellen und Posen voraussagen</translation>
    </message>
    <message>
        <source>But it is not this surface: the cells are tilted against it by %1 (rms). Positions and tilts together fit another one better: %2, with %3.</source>
        <translation>Aber es ist nicht diese Fläche: Die Zellen sind um %1 (Effektivwert) gegen sie geneigt. Lage und Neigung zusammen passen besser zu einer anderen: %2, mit %3.</translation>
    </message>
    <message>
        <source>The radius is off the true one by Δ = %1, and the cells lie ε = %2 (rms) off the true surface.</source>
        <translation>Der Radius weicht um Δ = %1 vom wahren ab, und die Zellen liegen ε = %2 (Effektivwert) neben der wahren Fläche.</translation>
    </message>
    <message>
        <source>Of %1 cells, %2 have their position and %3 their orientation within what was stated with 95 %.</source>
        <translation>Von %1 Zellen haben %2 ihre Position und %3 ihre Orientierung innerhalb dessen, was mit 95 % angegeben war.</translation>
    </message>
</context>
<context>
    <name>hexoderm::VerifyPanel</name>
    <message>
        <source>Hold-out pose</source>
        <translation>Zurückgehaltene Pose</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Do the cells lie on the surface they were put on?</source>
        <translation>Liegen die Zellen auf der Fläche, auf die sie aufgebracht sind?</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Pose that is held out</source>
        <translation>Pose, die zurückgehalten wird</translation>
    </message>
    <message>
        <source>By cell</source>
        <translation>Je Zelle</translation>
    </message>
    <message>
        <source>By link</source>
        <translation>Je Verbindung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>True radius</source>
        <translation>Wahrer Radius</translation>
    </message>
    <message>
        <source>The session has changed since: run it again.</source>
        <translation>Die Sitzung hat sich seitdem geändert: noch einmal prüfen.</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>There is no skin yet.</source>
        <translation>Noch gibt es keine Haut.</translation>
    </message>
    <message>
        <source>A calibration file holds no readings: open the session it was made of.</source>
        <translation>Eine Kalibrierdatei enthält keine Messwerte: die Sitzung öffnen, aus der sie stammt.</translation>
    </message>
    <message>
        <source>Not run yet.</source>
        <translation>Noch nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Fitted through the centres of the cells</source>
        <translation>Durch die Mitten der Zellen gelegt</translation>
    </message>
    <message>
        <source>Only a cylinder and a sphere have one radius to compare with.</source>
        <translation>Nur Zylinder und Kugel haben einen Radius zum Vergleichen.</translation>
    </message>
    <message>
        <source>A calibration, or a session that is then solved</source>
        <translation>Eine Kalibrierung oder eine Sitzung, die dann gelöst wird</translation>
    </message>
    <message>
        <source>Patch %1. %2</source>
        <translation>Hautstück %1. %2</translation>
    </message>
    <message>
        <source>Surface through the cells</source>
        <translation>Fläche durch die Zellen</translation>
    </message>
    <message>
        <source>True radius of the surface</source>
        <translation>Wahrer Radius der Fläche</translation>
    </message>
    <message>
        <source>Takes %1 other poses that are not disabled; besides this one there are %2.</source>
        <translation>Braucht %1 andere Posen, die benutzt werden; außer dieser: %2.</translation>
    </message>
    <message>
        <source>Takes %1 poses that are not disabled, and there is none yet.</source>
        <translation>Braucht %1 benutzte Posen, und noch gibt es keine.</translation>
    </message>
    <message>
        <source>Most probable</source>
        <translation>Wahrscheinlichste</translation>
    </message>
    <message>
        <source>Distance by caliper</source>
        <translation>Abstand mit dem Messschieber</translation>
    </message>
    <message>
        <source>One cell</source>
        <translation>Eine Zelle</translation>
    </message>
    <message>
        <source>The other cell</source>
        <translation>Die andere Zelle</translation>
    </message>
    <message>
        <source>Measured distance</source>
        <translation>Gemessener Abstand</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>From cell</source>
        <translation>Von Zelle</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Not measured yet: from the middle of one cell to the middle of the other, as straight as the jaws reach.</source>
        <translation>Noch nicht gemessen: von der Mitte der einen Zelle zur Mitte der anderen, auf geradem Weg zwischen den Schenkeln.</translation>
    </message>
    <message>
        <source>Cells far apart, across the bend, tell most</source>
        <translation>Weit entfernte Zellen, über die Biegung hinweg, sagen am meisten</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Choose the file of the old calibration</source>
        <translation>Datei der alten Kalibrierung wählen</translation>
    </message>
    <message>
        <source>Remove the old calibration</source>
        <translation>Alte Kalibrierung entfernen</translation>
    </message>
    <message>
        <source>Poses that the old calibration is compared with</source>
        <translation>Posen, mit denen die alte Kalibrierung verglichen wird</translation>
    </message>
    <message>
        <source>The newest pose</source>
        <translation>Die neueste Pose</translation>
    </message>
    <message>
        <source>The newest %1 poses</source>
        <translation>Die neuesten %1 Posen</translation>
    </message>
    <message>
        <source>All poses</source>
        <translation>Alle Posen</translation>
    </message>
    <message>
        <source>A calibration file holds no readings: open a session with the poses of today.</source>
        <translation>Eine Kalibrierdatei enthält keine Messwerte: eine Sitzung mit den Posen von heute öffnen.</translation>
    </message>
    <message>
        <source>Choose those that were taken since the calibration; disabled ones don&apos;t count</source>
        <translation>Die wählen, die seit der Kalibrierung aufgenommen wurden; nicht benutzte zählen nicht</translation>
    </message>
    <message>
        <source>Leave one pose out: do the others predict what it read?</source>
        <translation>Eine Pose weglassen: Sagen die anderen voraus, was sie maß?</translation>
    </message>
    <message>
        <source>Do rings of cells close, link by link?</source>
        <translation>Schließen sich Ringe von Zellen, Verbindung für Verbindung?</translation>
    </message>
    <message>
        <source>Does a distance measured on the skin itself agree?</source>
        <translation>Stimmt ein Abstand, der an der Haut selbst gemessen wurde?</translation>
    </message>
    <message>
        <source>Does another calibration of the same skin agree?</source>
        <translation>Stimmt eine andere Kalibrierung derselben Haut damit überein?</translation>
    </message>
    <message>
        <source>Does one of some time ago still hold? Compared with the poses of this session, cell by cell.</source>
        <translation>Gilt eine von früher noch? Zelle für Zelle mit den Posen dieser Sitzung verglichen.</translation>
    </message>
    <message>
        <source>Solves without this pose and compares what the others predict with what was read</source>
        <translation>Löst ohne diese Pose und vergleicht, was die anderen voraussagen, mit dem Gemessenen</translation>
    </message>
    <message>
        <source>Known from a drawing or measured: the fit is then compared with it</source>
        <translation>Aus einer Zeichnung bekannt oder gemessen: Die Ausgleichsfläche wird dann damit verglichen</translation>
    </message>
    <message>
        <source>Compare with another calibration</source>
        <translation>Mit anderer Kalibrierung vergleichen</translation>
    </message>
    <message>
        <source>Check an old calibration</source>
        <translation>Alte Kalibrierung prüfen</translation>
    </message>
</context>
<context>
    <name>hexoderm::VerifySection</name>
    <message>
        <source>Working</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Figures: %1</source>
        <translation>Zahlen: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::WelcomePanel</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Where is every cell of your skin?</source>
        <translation>Wo ist jede Zelle der Haut?</translation>
    </message>
    <message>
        <source>Hold the part still in a few poses; Hexoderm finds out from gravity.</source>
        <translation>Das Teil in ein paar Posen stillhalten; wo die Zellen sind, findet Hexoderm aus der Schwerkraft heraus.</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
</context>
<context>
    <name>hexoderm::WindowActions</name>
    <message>
        <source>Start the &amp;demo skin</source>
        <translation>&amp;Demo-Haut starten</translation>
    </message>
    <message>
        <source>A simulated skin to try everything with</source>
        <translation>Eine simulierte Haut, um alles auszuprobieren</translation>
    </message>
    <message>
        <source>&amp;Connect to a skin…</source>
        <translation>Mit einer Haut &amp;verbinden…</translation>
    </message>
    <message>
        <source>Take poses of a skin that is connected, or of a recording</source>
        <translation>Posen einer angeschlossenen Haut oder einer Aufzeichnung aufnehmen</translation>
    </message>
    <message>
        <source>D&amp;isconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>End the connection to the skin; what was captured stays</source>
        <translation>Die Verbindung zur Haut beenden; was aufgenommen ist, bleibt</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a session or a calibration</source>
        <translation>Sitzung oder Kalibrierung öffnen</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>Save the poses taken so far</source>
        <translation>Die bisher aufgenommenen Posen speichern</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Die Sitzung unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Save &amp;calibration…</source>
        <translation>&amp;Kalibrierung speichern…</translation>
    </message>
    <message>
        <source>Save the reconstruction, complete enough to export and draw from it alone</source>
        <translation>Das Ergebnis speichern, vollständig genug, um allein aus ihm zu exportieren und zu zeichnen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Write the calibration in a form that others read</source>
        <translation>Die Kalibrierung in einer Form schreiben, die andere lesen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Das Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Disable pose</source>
        <translation>Pose &amp;nicht benutzen</translation>
    </message>
    <message>
        <source>Leave the picked pose out, or take it back</source>
        <translation>Die gewählte Pose nicht benutzen oder wieder hinzunehmen</translation>
    </message>
    <message>
        <source>De&amp;lete pose</source>
        <translation>Pose &amp;löschen</translation>
    </message>
    <message>
        <source>Take the picked pose out of the session</source>
        <translation>Die gewählte Pose aus der Sitzung nehmen</translation>
    </message>
    <message>
        <source>Capture by itself when &amp;still</source>
        <translation>Von selbst aufnehmen, wenn &amp;ruhig</translation>
    </message>
    <message>
        <source>Take a pose as soon as the part is held still after it was moved</source>
        <translation>Eine Pose aufnehmen, sobald das Teil nach einer Bewegung stillgehalten wird</translation>
    </message>
    <message>
        <source>&amp;Turn to the next pose</source>
        <translation>Zur nächsten Pose &amp;drehen</translation>
    </message>
    <message>
        <source>Ask the device to turn itself to where the next pose helps most</source>
        <translation>Das Gerät bitten, sich dorthin zu drehen, wo die nächste Pose am meisten hilft</translation>
    </message>
    <message>
        <source>Find &amp;cell…</source>
        <translation>&amp;Zelle suchen…</translation>
    </message>
    <message>
        <source>Pick a cell by typing its ID</source>
        <translation>Eine Zelle durch Eintippen ihrer ID wählen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show the whole skin</source>
        <translation>Die ganze Haut zeigen</translation>
    </message>
    <message>
        <source>F&amp;ront view</source>
        <translation>Ansicht von &amp;vorn</translation>
    </message>
    <message>
        <source>Look at the patch from the front</source>
        <translation>Das Hautstück von vorn ansehen</translation>
    </message>
    <message>
        <source>&amp;Side view</source>
        <translation>Ansicht von der &amp;Seite</translation>
    </message>
    <message>
        <source>Look at the patch from its side</source>
        <translation>Das Hautstück von der Seite ansehen</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>Ansicht von &amp;oben</translation>
    </message>
    <message>
        <source>Look at the patch from above</source>
        <translation>Das Hautstück von oben ansehen</translation>
    </message>
    <message>
        <source>&amp;Picture of the window</source>
        <translation>&amp;Bild des Fensters</translation>
    </message>
    <message>
        <source>Save a picture of this window</source>
        <translation>Ein Bild dieses Fensters speichern</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>The list of keys</source>
        <translation>Die Liste der Tasten</translation>
    </message>
    <message>
        <source>&amp;About Hexoderm</source>
        <translation>Ü&amp;ber Hexoderm</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Start the demo skin</source>
        <translation>Demo-Haut starten</translation>
    </message>
    <message>
        <source>Like the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Light or dark, as the system asks for</source>
        <translation>Hell oder dunkel, wie das System es will</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark text on a light ground</source>
        <translation>Dunkle Schrift auf hellem Grund</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light text on a dark ground</source>
        <translation>Helle Schrift auf dunklem Grund</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Sitzung</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>The skin does not send: %1</source>
        <translation>Die Haut sendet nicht: %1</translation>
    </message>
    <message>
        <source>No skin is connected</source>
        <translation>Keine Haut ist verbunden</translation>
    </message>
    <message>
        <source>This device can&apos;t turn itself; turn the part by hand</source>
        <translation>Dieses Gerät kann sich nicht selbst drehen; das Teil von Hand drehen</translation>
    </message>
    <message>
        <source>The reconstruction is being brought up to date</source>
        <translation>Das Ergebnis wird auf den neuesten Stand gebracht</translation>
    </message>
    <message>
        <source>Nothing is open yet</source>
        <translation>Noch ist nichts offen</translation>
    </message>
    <message>
        <source>A calibration is open: it holds the result, not the poses</source>
        <translation>Eine Kalibrierung ist offen: Sie enthält das Ergebnis, nicht die Posen</translation>
    </message>
    <message>
        <source>There is no reconstruction yet</source>
        <translation>Es gibt noch kein Ergebnis</translation>
    </message>
    <message>
        <source>The last change could not be reconstructed; undo it first</source>
        <translation>Die letzte Änderung ließ sich nicht rekonstruieren; sie zuerst rückgängig machen</translation>
    </message>
    <message>
        <source>Pick a pose in the table of poses first</source>
        <translation>Zuerst eine Pose in der Tabelle der Posen wählen</translation>
    </message>
    <message>
        <source>&amp;Enable pose</source>
        <translation>Pose wieder be&amp;nutzen</translation>
    </message>
    <message>
        <source>There is nothing to look at yet</source>
        <translation>Noch gibt es nichts zu sehen</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts zu wiederholen</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>Be&amp;richt…</translation>
    </message>
    <message>
        <source>Write a report with verdict, pictures and tables, as PDF or as a page for the browser</source>
        <translation>Einen Bericht mit Urteil, Bildern und Tabellen schreiben, als PDF oder als Seite für den Browser</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>An&amp;leitung</translation>
    </message>
    <message>
        <source>How to calibrate a skin, page by page</source>
        <translation>Wie eine Haut kalibriert wird, Seite für Seite</translation>
    </message>
    <message>
        <source>&amp;Recapture pose</source>
        <translation>Pose &amp;neu aufnehmen</translation>
    </message>
    <message>
        <source>The next capture takes the place of the picked pose</source>
        <translation>Die nächste Aufnahme tritt an die Stelle der gewählten Pose</translation>
    </message>
    <message>
        <source>S&amp;kip this pose</source>
        <translation>Diese Pose &amp;auslassen</translation>
    </message>
    <message>
        <source>The part can&apos;t be held like this: advise the next best pose</source>
        <translation>So lässt sich das Teil nicht halten: eine andere Pose vorschlagen</translation>
    </message>
    <message>
        <source>Let the ro&amp;bot take the poses</source>
        <translation>&amp;Roboter starten</translation>
    </message>
    <message>
        <source>The device turns itself from pose to pose until there are enough</source>
        <translation>Das Gerät dreht sich von Pose zu Pose, bis es genug sind</translation>
    </message>
    <message>
        <source>&amp;Live mode</source>
        <translation>&amp;Live-Betrieb</translation>
    </message>
    <message>
        <source>Draw the skin from its readings of this moment alone</source>
        <translation>Die Haut allein aus den Messwerten dieses Augenblicks zeichnen</translation>
    </message>
    <message>
        <source>Li&amp;ght the picked cell</source>
        <translation>Gewählte Zelle &amp;leuchten lassen</translation>
    </message>
    <message>
        <source>Switch on the light of the picked cell on the skin itself</source>
        <translation>Das Licht der gewählten Zelle auf der Haut selbst einschalten</translation>
    </message>
    <message>
        <source>Show me the next pose</source>
        <translation>Nächste Pose zeigen</translation>
    </message>
    <message>
        <source>Open the step in which poses are captured</source>
        <translation>Den Schritt öffnen, in dem Posen aufgenommen werden</translation>
    </message>
    <message>
        <source>Show what does not fit</source>
        <translation>Zeigen, was nicht passt</translation>
    </message>
    <message>
        <source>Pick the cell or link that the most serious finding is about</source>
        <translation>Die Zelle oder Verbindung wählen, um die es beim schwersten Befund geht</translation>
    </message>
    <message>
        <source>The next pose is being worked out</source>
        <translation>Die nächste Pose wird berechnet</translation>
    </message>
    <message>
        <source>Let the simulated robot take the poses</source>
        <translation>Simulierten Roboter starten</translation>
    </message>
    <message>
        <source>Let the robot take the poses</source>
        <translation>Roboter starten</translation>
    </message>
    <message>
        <source>Stop the robot</source>
        <translation>Roboter anhalten</translation>
    </message>
    <message>
        <source>Any way up will do for the first pose</source>
        <translation>Für die erste Pose ist es egal, wie herum das Teil gehalten wird</translation>
    </message>
    <message>
        <source>There are enough poses; turn and capture more by hand if you like</source>
        <translation>Es sind genug Posen; weitere lassen sich von Hand drehen und aufnehmen</translation>
    </message>
    <message>
        <source>The cells of this device have no lights</source>
        <translation>Die Zellen dieses Geräts haben keine Lichter</translation>
    </message>
    <message>
        <source>Pick a cell first</source>
        <translation>Zuerst eine Zelle wählen</translation>
    </message>
    <message>
        <source>Don&apos;t &amp;recapture</source>
        <translation>Nicht &amp;neu aufnehmen</translation>
    </message>
    <message>
        <source>Set link &amp;aside</source>
        <translation>Verbindung &amp;ausschließen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Appearance, limits of the capture, options of the solver, folders</source>
        <translation>Aussehen, Grenzen der Aufnahme, Einstellungen des Lösers, Ordner</translation>
    </message>
    <message>
        <source>S&amp;wap graph and 3D view</source>
        <translation>Graph und 3D-Ansicht &amp;tauschen</translation>
    </message>
    <message>
        <source>The one in the middle goes to the side, and the other way round</source>
        <translation>Was in der Mitte ist, kommt zur Seite, und umgekehrt</translation>
    </message>
    <message>
        <source>&amp;Copy for a bug report</source>
        <translation>Für &amp;Fehlerbericht kopieren</translation>
    </message>
    <message>
        <source>&amp;Open the log&apos;s folder</source>
        <translation>&amp;Ordner des Protokolls öffnen</translation>
    </message>
    <message>
        <source>Show the folder in which the log is kept</source>
        <translation>Den Ordner zeigen, in dem das Protokoll liegt</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Step &amp;%1</source>
        <translation>Schritt &amp;%1</translation>
    </message>
    <message>
        <source>Open this step</source>
        <translation>Diesen Schritt öffnen</translation>
    </message>
    <message>
        <source>&amp;Go to step</source>
        <translation>&amp;Zum Schritt</translation>
    </message>
    <message>
        <source>Pick a link in the graph or in the table of links first</source>
        <translation>Zuerst eine Verbindung im Graphen oder in der Tabelle der Verbindungen wählen</translation>
    </message>
    <message>
        <source>Take link b&amp;ack</source>
        <translation>Verbindung &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Let the picked link into the solution again</source>
        <translation>Die gewählte Verbindung wieder in die Lösung nehmen</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>Take the keyboard to the next part: steps, pictures, tables</source>
        <translation>Die Tastatur zum nächsten Teil bringen: Schritte, Bilder, Tabellen</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>&amp;Voriger Teil des Fensters</translation>
    </message>
    <message>
        <source>Take the keyboard to the part before</source>
        <translation>Die Tastatur zum Teil davor bringen</translation>
    </message>
    <message>
        <source>End live mode</source>
        <translation>Live-Betrieb beenden</translation>
    </message>
    <message>
        <source>Live mode</source>
        <translation>Live-Betrieb</translation>
    </message>
    <message>
        <source>Switch the light of cell %1 off</source>
        <translation>Licht von Zelle %1 ausschalten</translation>
    </message>
    <message>
        <source>Light the picked cell</source>
        <translation>Gewählte Zelle leuchten lassen</translation>
    </message>
    <message>
        <source>Versions, graphics, what is open and the last lines of the log, with your home folder as ~</source>
        <translation>Versionen, Grafik, was offen ist und die letzten Zeilen des Protokolls, mit dem eigenen Ordner als ~</translation>
    </message>
    <message>
        <source>Take a &amp;pose again</source>
        <translation>Eine &amp;Pose neu aufnehmen</translation>
    </message>
    <message>
        <source>The next capture takes the place of the pose that keeps the result from being better</source>
        <translation>Die nächste Aufnahme tritt an die Stelle der Pose, deretwegen das Ergebnis nicht besser ist</translation>
    </message>
    <message>
        <source>No pose has to be taken again</source>
        <translation>Keine Pose muss neu aufgenommen werden</translation>
    </message>
    <message>
        <source>Don&apos;t take &amp;pose %1 again</source>
        <translation>&amp;Pose %1 nicht neu aufnehmen</translation>
    </message>
    <message>
        <source>Take &amp;pose %1 again</source>
        <translation>&amp;Pose %1 neu aufnehmen</translation>
    </message>
    <message>
        <source>Correct the address…</source>
        <translation>Adresse berichtigen…</translation>
    </message>
    <message>
        <source>A forearm with two patches and an elbow: a session to place on its robot</source>
        <translation>Ein Unterarm mit zwei Hautstücken und einem Ellbogen: eine Sitzung, die am Roboter einzuordnen ist</translation>
    </message>
    <message>
        <source>Start the demo a&amp;rm</source>
        <translation>Demo-A&amp;rm starten</translation>
    </message>
    <message>
        <source>Bac&amp;k view</source>
        <translation>Ansicht von &amp;hinten</translation>
    </message>
    <message>
        <source>Look at the patch from behind</source>
        <translation>Das Hautstück von hinten ansehen</translation>
    </message>
    <message>
        <source>&amp;Isometric view</source>
        <translation>&amp;Isometrische Ansicht</translation>
    </message>
    <message>
        <source>Look at the patch from between its axes</source>
        <translation>Das Hautstück von zwischen seinen Achsen ansehen</translation>
    </message>
    <message>
        <source>Worst ce&amp;ll</source>
        <translation>&amp;Unsicherste Zelle</translation>
    </message>
    <message>
        <source>Pick the cell that is known least certainly, and show its figures and its neighbours</source>
        <translation>Die Zelle auswählen, die am wenigsten sicher bekannt ist, und ihre Werte und Nachbarn zeigen</translation>
    </message>
    <message>
        <source>F&amp;igures of what is picked</source>
        <translation>&amp;Werte des Ausgewählten</translation>
    </message>
    <message>
        <source>Keep a card with all figures of the picked cell or link over the picture, or close it</source>
        <translation>Eine Karte mit allen Werten der ausgewählten Zelle oder Verbindung über dem Bild behalten oder schließen</translation>
    </message>
    <message>
        <source>How certain the cells are is not known yet</source>
        <translation>Wie sicher die Zellen bekannt sind, weiß noch niemand</translation>
    </message>
    <message>
        <source>Keep the picked link out of the solution, if it is a cable for example</source>
        <translation>Die gewählte Verbindung aus der Lösung heraushalten, wenn sie zum Beispiel ein Kabel ist</translation>
    </message>
    <message>
        <source>Capture &amp;now</source>
        <translation>&amp;Jetzt aufnehmen</translation>
    </message>
    <message>
        <source>Take the next readings as a pose, whether the part is still or not</source>
        <translation>Die nächsten Messwerte als Pose nehmen, ob das Teil ruhig ist oder nicht</translation>
    </message>
    <message>
        <source>Stop working out the last change; what is shown stays as it was before</source>
        <translation>Die Berechnung der letzten Änderung abbrechen; was gezeigt wird, bleibt wie vorher</translation>
    </message>
    <message>
        <source>&amp;Work it out after all</source>
        <translation>&amp;Doch berechnen</translation>
    </message>
    <message>
        <source>R&amp;eset layout</source>
        <translation>An&amp;ordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Bring all panels back to where they were at the first start</source>
        <translation>Alle Bereiche dorthin zurückbringen, wo sie beim ersten Start waren</translation>
    </message>
    <message>
        <source>Nothing is being worked out</source>
        <translation>Es wird nichts berechnet</translation>
    </message>
    <message>
        <source>Stop working it o&amp;ut</source>
        <translation>Berechn&amp;ung abbrechen</translation>
    </message>
    <message>
        <source>Work out the result that was stopped before</source>
        <translation>Das Ergebnis berechnen, dessen Berechnung abgebrochen wurde</translation>
    </message>
    <message>
        <source>Nothing was stopped</source>
        <translation>Es wurde nichts abgebrochen</translation>
    </message>
    <message>
        <source>Working out the last change was stopped; work it out after all first</source>
        <translation>Die Berechnung der letzten Änderung wurde abgebrochen; sie zuerst doch berechnen</translation>
    </message>
    <message>
        <source>&amp;Title of reports…</source>
        <translation>&amp;Titel der Berichte…</translation>
    </message>
    <message>
        <source>Robot, part, operator and notes, as they stand at the head of reports on this session</source>
        <translation>Roboter, Teil, Bedienung und Notizen, wie sie am Kopf der Berichte über diese Sitzung stehen</translation>
    </message>
    <message>
        <source>P&amp;lot of figures</source>
        <translation>Dia&amp;gramm der Kennwerte</translation>
    </message>
    <message>
        <source>Any figure of cells or links against any other; what is marked there is marked in all views</source>
        <translation>Jeder Kennwert der Zellen oder Verbindungen über jedem anderen; was dort markiert wird, ist in allen Ansichten markiert</translation>
    </message>
    <message>
        <source>Before and &amp;after</source>
        <translation>Vorher und n&amp;achher</translation>
    </message>
    <message>
        <source>The result of now beside an earlier one, seen from the same side, or with arrows between them</source>
        <translation>Das jetzige Ergebnis neben einem früheren, von derselben Seite gesehen, oder mit Pfeilen dazwischen</translation>
    </message>
    <message>
        <source>Nothing was found that does not fit</source>
        <translation>Es wurde nichts gefunden, was nicht passt</translation>
    </message>
</context>
<context>
    <name>hexoderm::WindowParts</name>
    <message>
        <source>Step &amp;%1: %2</source>
        <translation>Schritt &amp;%1: %2</translation>
    </message>
    <message>
        <source>About Hexoderm</source>
        <translation>Über Hexoderm</translation>
    </message>
    <message>
        <source>&lt;b&gt;Hexoderm %1&lt;/b&gt;&lt;p&gt;Finds out where every cell of a robot&apos;s artificial skin is.&lt;/p&gt;&lt;p&gt;BSD 3-Clause licence.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Hexoderm %1&lt;/b&gt;&lt;p&gt;Findet heraus, wo jede Zelle der künstlichen Haut eines Roboters ist.&lt;/p&gt;&lt;p&gt;BSD-3-Klausel-Lizenz.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>One session was not saved: %1</source>
        <translation>Eine Sitzung wurde nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>%1 sessions were not saved. The newest: %2</source>
        <translation>%1 Sitzungen wurden nicht gespeichert. Die neueste: %2</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Copied: versions, graphics, what is open and the last lines of the log, with your home folder as ~. Paste it into the report.</source>
        <translation>Kopiert: Versionen, Grafik, was offen ist und die letzten Zeilen des Protokolls, mit dem eigenen Ordner als ~. In den Bericht einfügen.</translation>
    </message>
    <message>
        <source>No program to show folders was found. The log is %1.</source>
        <translation>Es wurde kein Programm gefunden, das Ordner zeigt. Das Protokoll ist %1.</translation>
    </message>
    <message>
        <source>The log is kept in memory only. %1</source>
        <translation>Das Protokoll bleibt nur im Speicher. %1</translation>
    </message>
    <message>
        <source>There is no OpenGL 3.2 here, so the 3D view is empty; graph and tables work.</source>
        <translation>Hier gibt es kein OpenGL 3.2, darum ist die 3D-Ansicht leer; Graph und Tabellen arbeiten.</translation>
    </message>
    <message>
        <source>%1 Drawing by the processor did not help either.</source>
        <translation>%1 Auch Zeichnen im Prozessor half nicht.</translation>
    </message>
    <message>
        <source>Draw without the graphics card</source>
        <translation>Ohne Grafikkarte zeichnen</translation>
    </message>
    <message>
        <source>From the next start on, the processor draws. Start Hexoderm again when it suits you.</source>
        <translation>Ab dem nächsten Start zeichnet der Prozessor. Hexoderm bei Gelegenheit neu starten.</translation>
    </message>
    <message>
        <source>No skin</source>
        <translation>Keine Haut</translation>
    </message>
    <message>
        <source>Hexoderm</source>
        <translation>Hexoderm</translation>
    </message>
    <message>
        <source>%1[*] · Hexoderm</source>
        <translation>%1[*] · Hexoderm</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>cells %1/%2</source>
        <translation>Zellen %1/%2</translation>
    </message>
    <message>
        <source>Cells that were measured in the fullest pose, of all cells</source>
        <translation>Zellen, die in der vollständigsten Pose gemessen wurden, von allen</translation>
    </message>
    <message>
        <source>solved in %1 · %2</source>
        <translation>gelöst in %1 · %2</translation>
    </message>
    <message>
        <source>%1, read from the file</source>
        <translation>%1, aus der Datei</translation>
    </message>
    <message>
        <source>How long the last result took to work out, and by which method: global uses all links and poses at once, tree goes from cell to cell as in the paper</source>
        <translation>Wie lange die Berechnung des letzten Ergebnisses dauerte, und nach welchem Verfahren: global nimmt alle Verbindungen und Posen auf einmal, tree geht wie im Aufsatz von Zelle zu Zelle</translation>
    </message>
    <message>
        <source>not on disk</source>
        <translation>nicht auf der Platte</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>saved at %1</source>
        <translation>gespeichert um %1</translation>
    </message>
    <message>
        <source>R recapture · Del disable · Ctrl+Z undo</source>
        <translation>R: neu · Entf: aus · Strg+Z: zurück</translation>
    </message>
    <message>
        <source>Del disable · Ctrl+Z undo</source>
        <translation>Entf: aus · Strg+Z: zurück</translation>
    </message>
    <message>
        <source>Findings %1</source>
        <translation>Befunde %1</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Links %1</source>
        <translation>Verbindungen %1</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Cells %1</source>
        <translation>Zellen %1</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Compare with an earlier calibration</source>
        <translation>Mit früherer Kalibrierung vergleichen</translation>
    </message>
    <message>
        <source>Calibrations and sessions (*.calibration.json *.hexo *.session.json *.xml)</source>
        <translation>Kalibrierungen und Sitzungen (*.calibration.json *.hexo *.session.json *.xml)</translation>
    </message>
    <message>
        <source>Check an old calibration</source>
        <translation>Eine alte Kalibrierung prüfen</translation>
    </message>
    <message>
        <source>Calibrations and sessions (*.calibration.json *.hexo *.session.json)</source>
        <translation>Kalibrierungen und Sitzungen (*.calibration.json *.hexo *.session.json)</translation>
    </message>
</context>
<context>
    <name>hexoderm::Words</name>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>Path from the origin: %1 (%2)</source>
        <translation>Weg vom Ursprung: %1 (%2)</translation>
    </message>
    <message>
        <source>Residual in the worst poses %1</source>
        <translation>Restfehler in den schlechtesten Posen %1</translation>
    </message>
    <message>
        <source>Residual in pose %1</source>
        <translation>Restfehler in Pose %1</translation>
    </message>
    <message>
        <source>Link %1 · port %2 — %3 · port %4</source>
        <translation>Verbindung %1 · Port %2 — %3 · Port %4</translation>
    </message>
    <message>
        <source>It is not used.</source>
        <translation>Sie wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>cells %1</source>
        <translation>Zellen %1</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>poses %1</source>
        <translation>Posen %1</translation>
    </message>
    <message>
        <source>Used, on the shortest paths to the origin</source>
        <translation>Benutzt, auf den kürzesten Wegen zum Ursprung</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>Muted: %1</source>
        <translation>Ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>%1, singular values %2, %3, %4; weight %5</source>
        <translation>%1, Singulärwerte %2; %3; %4; Gewicht %5</translation>
    </message>
    <message>
        <source>Bend %1, twist %2, yaw %3</source>
        <translation>Biegung %1, Verwindung %2, Gieren %3</translation>
    </message>
    <message>
        <source>Residual %1, predicted deviation %2</source>
        <translation>Restfehler %1, erwartete Abweichung %2</translation>
    </message>
    <message>
        <source>Centred: the mean of each cell&apos;s readings was subtracted</source>
        <translation>Zentriert: Das Mittel der Messwerte jeder Zelle wurde abgezogen</translation>
    </message>
    <message>
        <source>Support axes were added: the poses alone do not fix it</source>
        <translation>Stützachsen wurden hinzugefügt: Die Posen allein legen sie nicht fest</translation>
    </message>
    <message>
        <source>Origin of patch %1</source>
        <translation>Ursprung von Hautstück %1</translation>
    </message>
    <message>
        <source>Patch %1</source>
        <translation>Hautstück %1</translation>
    </message>
    <message>
        <source>On %1</source>
        <translation>Auf %1</translation>
    </message>
    <message>
        <source>Placed through its links: its own readings are not used</source>
        <translation>Über ihre Verbindungen verortet: Ihre eigenen Messwerte werden nicht benutzt</translation>
    </message>
    <message>
        <source>Placed by its own readings</source>
        <translation>Durch eigene Messwerte verortet</translation>
    </message>
    <message>
        <source>At %1 mm from the origin</source>
        <translation>Bei %1 mm vom Ursprung</translation>
    </message>
    <message>
        <source>Roll %1, pitch %2, yaw %3</source>
        <translation>Rollen %1, Nicken %2, Gieren %3</translation>
    </message>
    <message>
        <source>How well it is known is not stated</source>
        <translation>Wie gut es bekannt ist, ist nicht angegeben</translation>
    </message>
    <message>
        <source>Accelerometer offset %1 mg</source>
        <translation>Nullpunkt des Sensors %1 mg</translation>
    </message>
    <message>
        <source>Accelerometer scale %1</source>
        <translation>Skalierung des Sensors %1</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>no poses</source>
        <translation>keine Posen</translation>
    </message>
    <message>
        <source>1 pose</source>
        <translation>1 Pose</translation>
    </message>
    <message>
        <source>%1 poses</source>
        <translation>%1 Posen</translation>
    </message>
    <message>
        <source>Known to ±%1, ±%2 (95 %)</source>
        <translation>Bekannt auf ±%1, ±%2 (95 %)</translation>
    </message>
    <message>
        <source>In the shape known to ±%1, ±%2 (95 %)</source>
        <translation>In der Form bekannt auf ±%1, ±%2 (95 %)</translation>
    </message>
    <message>
        <source>Worst link: %1, residual %2, predicted deviation %3</source>
        <translation>Schlechteste Verbindung: %1, Restfehler %2, erwartete Abweichung %3</translation>
    </message>
    <message>
        <source>Shared by its lot: %1</source>
        <translation>Davon der ganzen Charge gemeinsam: %1</translation>
    </message>
</context>
<context>
    <name>hexoderm::WorkNotice</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Work that takes a while</source>
        <translation>Arbeit, die etwas dauert</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop this; what is shown stays as it was before</source>
        <translation>Das abbrechen; was gezeigt wird, bleibt wie vorher</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Finds out where every cell of a robot&apos;s artificial skin is.</source>
        <translation>Findet heraus, wo jede Zelle der künstlichen Haut eines Roboters ist.</translation>
    </message>
    <message>
        <source>A session or calibration to open.</source>
        <translation>Eine Sitzung oder Kalibrierung zum Öffnen.</translation>
    </message>
    <message>
        <source>Start the demo skin.</source>
        <translation>Die Demo-Haut starten.</translation>
    </message>
    <message>
        <source>Let the demo take N poses at once.</source>
        <translation>Die Demo gleich N Posen aufnehmen lassen.</translation>
    </message>
    <message>
        <source>light, dark or system, for this time.</source>
        <translation>light, dark oder system, für dieses Mal.</translation>
    </message>
    <message>
        <source>en, de or system, for this time.</source>
        <translation>en, de oder system, für dieses Mal.</translation>
    </message>
    <message>
        <source>Save a picture of the window after the first result, and quit.</source>
        <translation>Nach dem ersten Ergebnis ein Bild des Fensters speichern und beenden.</translation>
    </message>
    <message>
        <source>One file at a time; see --help.</source>
        <translation>Nur eine Datei auf einmal; siehe --help.</translation>
    </message>
    <message>
        <source>Give either --demo or a file, not both.</source>
        <translation>Entweder --demo oder eine Datei angeben, nicht beides.</translation>
    </message>
    <message>
        <source>--poses takes a number from 0 to 1000.</source>
        <translation>--poses nimmt eine Zahl von 0 bis 1000.</translation>
    </message>
    <message>
        <source>--poses goes with --demo.</source>
        <translation>--poses gehört zu --demo.</translation>
    </message>
    <message>
        <source>--theme takes light, dark or system.</source>
        <translation>--theme nimmt light, dark oder system.</translation>
    </message>
    <message>
        <source>--language takes en, de or system.</source>
        <translation>--language nimmt en, de oder system.</translation>
    </message>
    <message>
        <source>--screenshot needs a file or --demo to show.</source>
        <translation>--screenshot braucht eine Datei oder --demo zum Zeigen.</translation>
    </message>
    <message>
        <source>The picture %1 could not be written.</source>
        <translation>Das Bild %1 ließ sich nicht schreiben.</translation>
    </message>
    <message>
        <source>Draw in 3D without the graphics card, for this time.</source>
        <translation>3D ohne Grafikkarte zeichnen, für dieses Mal.</translation>
    </message>
    <message>
        <source>The window needs a display, and none can be reached: set DISPLAY, or use hexoderm-cli.</source>
        <translation>Das Fenster braucht einen Bildschirm, und keiner ist zu erreichen: DISPLAY setzen oder hexoderm-cli verwenden.</translation>
    </message>
    <message>
        <source>The robot took %1 of %2 poses, and stopped.</source>
        <translation>Der Roboter hat %1 von %2 Posen aufgenommen und dann aufgehört.</translation>
    </message>
</context>
</TS>

import re
W='./'
def sub(p,pairs):
    s=open(W+p).read()
    for a,b in pairs:
        assert s.count(a)==1,(p,a,s.count(a))
        s=s.replace(a,b)
    open(W+p,'w').write(s)
sub('core/hexoderm/util/finding.h',[('  InconsistentPose,\n};','  InconsistentPose,\n  // the estimate\n  NotConverged,\n};')])
meaning="The joint estimate of a patch ended before its optimum; placements and stated uncertainties are preliminary."
why="The estimate goes on in steps as long as they make the shape more probable, and the steps ran out."
what="Take another pose: two alone often leave open where the optimum is. Until then rely on no figure of this patch."
sub('core/hexoderm/util/finding.cpp',[('''the part moved.")},
  };''','''the part moved.")},
      FindingDescription{
          NotConverged, "not-converged", Severity::Warning,
          message("The joint estimate of a patch ended before its optimum; placements and stated uncertainties are "
                  "preliminary.")},
  };'''),('static_cast<std::size_t>(InconsistentPose) + 1','static_cast<std::size_t>(NotConverged) + 1')])
sub('core/hexoderm/util/finding_advice.cpp',[('''          {RecapturePose, DisablePose}},
  };''','''          {RecapturePose, DisablePose}},
      FindingAdvice{NotConverged,
                    message("The estimate goes on in steps as long as they make the shape more probable, and the steps "
                            "ran out."),
                    message("Take another pose: two alone often leave open where the optimum is. Until then rely on no "
                            "figure of this patch."),
                    {TakePose}},
  };'''),('static_cast<std::size_t>(InconsistentPose) + 1','static_cast<std::size_t>(NotConverged) + 1')])
s=open(W+'core/hexoderm/util/README.md').read()
lines=s.split('\n'); out=[]; n=0
for l in lines:
    out.append(l)
    if l.startswith('| `inconsistent-pose` | warning'):
        out.append('| `not-converged` | warning | '+meaning+' |'); n+=1
    elif l.startswith('| `inconsistent-pose` |'):
        out.append('| `not-converged` | '+why+' | '+what+' | take another pose |'); n+=1
assert n==2
open(W+'core/hexoderm/util/README.md','w').write('\n'.join(out))
sub('core/hexoderm/reconstruction/patch/patch_solver.h',[('''void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings);
''','''void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings);

/// Says it where the joint estimate of the patch with this origin ended before its optimum.
void nameUnconverged(CellId origin, const JointSolution& solution, std::vector<Finding>& findings);
''')])
s=open(W+'core/hexoderm/reconstruction/patch/patch_solver.cpp').read()
assert s.endswith('}\n\n}  // namespace hexoderm\n')
s=s[:-len('}  // namespace hexoderm\n')]+'''void nameUnconverged(CellId origin, const JointSolution& solution, std::vector<Finding>& findings) {
  if (solution.termination != JointTermination::StepLimit) return;
  findings.push_back(makeFinding(
      FindingCode::NotConverged,
      message("The joint estimate of the patch of cell {} has not converged after {} steps: a more probable shape is "
              "nearby, and the stated uncertainty can't be relied on. Take another pose.",
              origin, solution.iterations),
      {origin}));
}

}  // namespace hexoderm
'''
open(W+'core/hexoderm/reconstruction/patch/patch_solver.cpp','w').write(s)
sub('core/hexoderm/reconstruction/solved_skin.cpp',[('''    for (const PatchSolver& patch : patches) nameInconsistentPoses(skin, patch, findings);
''','''    for (const PatchSolver& patch : patches) {
      nameInconsistentPoses(skin, patch, findings);
      nameUnconverged(skin.graph().cells()[patch.origin()].id, patch.joint()->solution(), findings);
    }
''')])
p=W+'tests/core/reconstruction/patch/patch_solver_test.cpp'
s=open(p).read()
i=s.rindex('}  // namespace\n}  // namespace hexoderm')
s=s[:i]+'''TEST(PatchSolver, AnEstimateThatHasNotConvergedIsAFinding) {
  std::vector<Finding> findings;
  JointSolution solution;
  nameUnconverged(CellId(7), solution, findings);
  EXPECT_TRUE(findings.empty());
  solution.termination = JointTermination::StepLimit;
  solution.iterations = 100;
  nameUnconverged(CellId(7), solution, findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, FindingCode::NotConverged);
  EXPECT_EQ(findings[0].severity, Severity::Warning) << "no such result is called good";
  EXPECT_EQ(findings[0].cells, std::vector<CellId>{CellId(7)});
  EXPECT_NE(findings[0].message.english().find("100 steps"), std::string::npos);
}

'''+s[i:]
open(p,'w').write(s)
p=W+'resources/translations/hexoderm_de.ts'
s=open(p).read()
def msg(src,tr): return '    <message>\n        <source>%s</source>\n        <translation>%s</translation>\n    </message>\n'%(src.replace("'","&apos;"),tr)
anchor=s.index('        <source>What limits it is how the cells lie in the mould')
anchor=s.rindex('    <message>\n',0,anchor)
s=s[:anchor]+msg(meaning,'Die gemeinsame Schätzung eines Hautstücks endete vor ihrem Optimum; Lagen und angegebene Unsicherheiten sind vorläufig.')+msg(why,'Die Schätzung geht in Schritten weiter, solange sie die Form wahrscheinlicher machen, und die Schritte gingen aus.')+msg(what,'Eine weitere Pose aufnehmen: Zwei allein lassen oft offen, wo das Optimum liegt. Bis dahin ist auf keine Angabe zu diesem Hautstück Verlass.')+msg("The joint estimate of the patch of cell {} has not converged after {} steps: a more probable shape is nearby, and the stated uncertainty can't be relied on. Take another pose.",'Die gemeinsame Schätzung des Hautstücks von Zelle {} ist nach {} Schritten nicht konvergiert: Eine wahrscheinlichere Form liegt in der Nähe, und auf die angegebene Unsicherheit ist kein Verlass. Nehmen Sie eine weitere Pose auf.')+s[anchor:]
open(p,'w').write(s)

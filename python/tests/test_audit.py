"""Verdicts: those of the command, as objects."""

import json
import pickle
import threading

import pytest

import sextic

SPRING = """# A spring
```sextic
parameter m : kg > 0
parameter k : N/m > 0
ω := sqrt(k/m)
claim (1): m*ω^2 == k  "the frequency"
refute (2): m*ω^2 == 2*k
```
"""
WRONG = SPRING.replace("sqrt(k/m)", "sqrt(k/M)")


def test_claims_are_those_of_the_command(paper, command):
    (document,) = command("audit", paper.path, "--format", "json")["documents"]
    assert len(paper) == len(document["claims"]) > 200
    for claim, own in zip(paper, document["claims"]):
        for name in ["id", "label", "line", "description", "statement", "expected", "verdict", "as_expected", "reason"]:
            assert getattr(claim, name) == own[name]
        assert list(claim.conditions) == own["conditions"]
        assert claim.point == (own["witness"] and own["witness"]["point"])
    assert paper.as_expected is document["as_expected"] is True
    assert str(paper).strip() == command("audit", paper.path, "--width", "100", is_json=False).strip()


def test_a_text_is_audited(tmp_path):
    found = sextic.audit(SPRING)
    assert [claim.verdict for claim in found] == ["holds", "refuted"]
    assert found.as_expected and found.title == "A spring"
    assert found["2"] is found["(2)"]
    assert found["2"].point.keys() == {"k", "m"}
    assert "refuted" in str(found["2"]) and "1 holds" in repr(found)
    path = tmp_path / "spring.md"
    path.write_text(SPRING, encoding="utf-8")
    assert sextic.audit(path).claims == found.claims


def test_what_a_notebook_shows_is_escaped():
    page = sextic.audit(SPRING.replace('"the frequency"', '"a < b & c"'))._repr_html_()
    assert "a &lt; b &amp; c" in page and page.count("<tr>") == 3


def test_imports_are_read_beside_a_document(tmp_path):
    (tmp_path / "one.md").write_text(SPRING, encoding="utf-8")
    other = tmp_path / "other.md"
    other.write_text('# Other\n```sextic\nimport "one.md"\nclaim (3): ω^2 == k/m\n```\n', encoding="utf-8")
    assert sextic.audit(other)["3"].verdict == "holds"


def test_shipped_documents_need_no_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert sextic.audit("derivations/uniform.md").as_expected


def test_a_mistake_has_a_place_and_costs_one_statement(command, tmp_path):
    found = sextic.audit(WRONG)
    (mistake,) = found.mistakes
    assert isinstance(mistake, sextic.DocumentError) and isinstance(mistake, sextic.Error)
    assert (mistake.line, mistake.column, mistake.kind) == (5, 13, "unknown-name")
    assert not found.as_expected and found["1"].verdict == "skipped"
    path = tmp_path / "wrong.md"
    path.write_text(WRONG, encoding="utf-8")
    (told,) = command("audit", str(path), "--format", "json")["diagnostics"]
    assert (mistake.message, mistake.help or None) == (told["message"], told["help"])
    assert str(pickle.loads(pickle.dumps(mistake))) == str(mistake)


@pytest.mark.parametrize("document", ["# Nothing\n\nis here\n", "missing.md", ".", "derivation/uniform.md"])
def test_what_cannot_be_read_is_an_exception(document, command):
    with pytest.raises(sextic.Error) as raised:
        sextic.audit(document)
    if "\n" not in document:
        command("audit", document)
        assert raised.value.message in command.error and raised.value.help in command.error


def test_unknown_claims_are_told_with_what_is_meant(paper):
    with pytest.raises(sextic.InputError, match="did you mean `12-printed`"):
        paper["12-prnted"]


def test_expressions_become_sympy(paper):
    sympy = pytest.importorskip("sympy")
    m, omega, k = sympy.symbols("m omega k")
    assert sextic.audit(SPRING)["1"].statement.sympy() == sympy.Eq(m * omega**2, k, evaluate=False)
    matrix = sextic.Expression("[a, 1/2; b_1.c, sin(x)]").sympy()
    half = sympy.Rational(1, 2)
    assert matrix == sympy.Matrix([[sympy.Symbol("a"), half], [sympy.Symbol("b_1.c"), sympy.sin(sympy.Symbol("x"))]])
    for text in ["S + E + lamda", "beta*gamma", "I*N"]:
        names = {own.name for own in sextic.Expression(text).sympy().free_symbols}
        assert names == {word for word in text.replace("*", " ").replace("+", " ").split()}
    for claim in paper:
        for condition in claim.conditions:
            condition.sympy()
        if claim.residual is not None:
            claim.residual.sympy()
    with pytest.raises(sextic.InputError, match="stay text"):
        sextic.Expression("x at rest").sympy()


def test_text_is_no_python():
    pytest.importorskip("sympy")
    with pytest.raises(sextic.InputError):
        sextic.Expression("__import__('os').system('true')").sympy()


def test_audits_run_in_threads_with_little_stack():
    threading.stack_size(256 * 1024)
    try:
        found = []
        threads = [threading.Thread(target=lambda: found.append(sextic.audit(SPRING))) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        threading.stack_size(0)
    assert [own.as_expected for own in found] == [True] * 4


def test_json_of_the_document_is_whole(paper):
    assert json.loads(paper._document.json())["documents"][0]["path"] == paper.path

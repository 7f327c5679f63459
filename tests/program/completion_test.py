"""What completes the program's words in a shell, and the man page: made from the help, and so as complete."""

import re
import shutil
import subprocess

from program import ProgramTest, main


class CompletionTest(ProgramTest):
    def script(self, shell):
        return self.succeeds("completion", shell).stdout

    def commands(self):
        table = self.succeeds("--help-markdown").stdout
        return re.findall(r"^\| `([a-z]+)` \|", table[table.index("| Commands |"):], re.MULTILINE)

    def options(self, command):
        """Lists of an option's names."""
        text = self.succeeds(command, "--help-markdown").stdout
        return [[name.split(" ")[0] for name in re.findall(r"`(-[^`]*)`", cell)]
                for cell in re.findall(r"^\| (`-.*?) \| ", text, re.MULTILINE)]

    def shell(self, name, *arguments):
        """Runs the shell, where there is one; without it the test is skipped once all else is checked."""
        if not shutil.which(name):
            self.skipTest(f"no {name} here")
        result = subprocess.run([name, *arguments], cwd=self.folder, text=True, capture_output=True,
                                timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout


class Bash(CompletionTest):
    def completed(self, *words):
        """What the last word may become; bash takes `=` for a word of its own."""
        (self.folder / "script").write_text(self.script("bash"))
        said = self.shell("bash", "--norc", "-c", 'source ./script; COMP_WORDS=("$@"); '
                          'COMP_CWORD=$(($# - 1)); _caustics; printf "%s\\n" "${COMPREPLY[@]}"',
                          "bash", "caustics", *words)
        return said.split()

    def test_begins_of_commands_and_options_become_words(self):
        self.assertEqual(self.completed("rend"), ["render"])
        self.assertEqual(self.completed("ba"), ["ball.glb"])
        self.assertEqual(self.completed("render", "--estim"), ["--estimator"])
        self.assertEqual(self.completed("ball.glb", "--estim"), ["--estimator"])
        self.assertEqual(self.completed("plan", "--estim"), ["--estimator"])
        self.assertEqual(self.completed("paper", "--estim"), [])
        self.assertEqual(self.completed("completion", "z"), ["zsh"])

    def test_values_of_choices_and_settings_become_words(self):
        self.assertEqual(self.completed("render", "--estimator", "n"), ["newton"])
        self.assertEqual(self.completed("--splat", "=", "c"), ["cell"])
        self.assertEqual(self.completed("render", "--aov", "beauty,dep"), ["beauty,depth"])
        self.assertEqual(self.completed("plan", "-D", "splat"), ["splat=", "splat.sigma="])
        self.assertEqual(self.completed("plan", "-D", "splat", "=", "g"), ["gaussian"])
        self.assertEqual(self.completed("study", "--vary", "iter"), ["iterations="])
        # The reference has no maps.
        self.assertEqual(self.completed("reference", "-D", "gri"), [])

    def test_every_option_of_every_command_is_there(self):
        for command in self.commands():
            known = set(self.completed(command, "-"))
            for names in self.options(command):
                self.assertLessEqual(set(names), known, command)


class OtherShells(CompletionTest):
    def test_zsh_has_every_command_and_option_and_takes_the_script(self):
        script = self.script("zsh")
        self.assertTrue(script.startswith("#compdef caustics\n"))
        for command in self.commands():
            start = script.index(f"\n    {command})\n")
            part = script[start:script.index(";;", start)]
            for names in self.options(command):
                word = "{" + ",".join(names) + "}" if len(names) > 1 else names[0]
                self.assertIn(f"'*'{word}'[", part, command)
        (self.folder / "script").write_text(script)
        self.shell("zsh", "-f", "-n", "script")

    def test_fish_has_every_command_and_option_and_completes(self):
        script = self.script("fish")
        for command in self.commands():
            self.assertIn(f"-n __fish_use_subcommand -a {command} -d '", script)
            for names in self.options(command):
                long = names[-1].lstrip("-")
                self.assertRegex(script, rf"(?m)^complete .* -[ls] {re.escape(long)} .*-d '")
        (self.folder / "script").write_text(script)
        said = self.shell("fish", "--no-config", "-c",
                          "source ./script; complete -C 'caustics render --estimator n'")
        self.assertEqual(said.split("\t")[0], "newton")


class ManPage(CompletionTest):
    def test_has_every_command_option_and_exit_code(self):
        page = self.script("man")
        self.assertTrue(page.startswith(".TH CAUSTICS 1 "))
        plain = page.replace("\\-", "-")
        for command in self.commands():
            self.assertIn(f".SH caustics {command}\n", plain)
            for names in self.options(command):
                self.assertIn(r"\fB" + ", ".join(names) + r"\fR", plain)
        self.assertIn("\\fB130\\fR\ninterrupted", plain)

    def test_is_what_man_takes(self):
        (self.folder / "caustics.1").write_text(self.script("man"))
        said = self.shell("man", "--warnings", "-l", "caustics.1")
        self.assertIn("CAUSTICS(1)", said)


class Mistakes(CompletionTest):
    def test_unknown_shells_are_refused(self):
        self.fails(2, "completion", saying="bash, zsh, fish, man")
        self.fails(2, "completion", "bsh", saying="did you mean 'bash'?")
        self.fails(2, "completion", "tcsh", saying="known: 'bash', 'zsh', 'fish', 'man'")


if __name__ == "__main__":
    main()

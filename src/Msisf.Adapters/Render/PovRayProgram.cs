using System.Text.RegularExpressions;
using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Render;

/// <summary>Finds POV-Ray and its version: versions draw differently.</summary>
public static partial class PovRayProgram
{
    /// <summary>The answer of a program that names no version, such as one that stands in for POV-Ray.</summary>
    public const string UnknownVersion = "unknown";

    /// <summary>The highest exit code of a program's own; those of killed programs are higher.</summary>
    private const int LastOwnExitCode = 128;

    private static readonly TimeSpan LongestAnswer = TimeSpan.FromSeconds(60); // over a network file system at its busiest

    private static readonly string[] Names = OperatingSystem.IsWindows() ? ["povray.exe", "pvengine64.exe"] : ["povray"];

    /// <summary>The program to start.</summary>
    /// <param name="givenPath">
    /// The user's <c>--pov-path</c>: the program, or the folder that holds it; null looks along <paramref name="searchPath"/>.
    /// </param>
    /// <param name="searchPath">Folders in the form of the PATH variable.</param>
    /// <exception cref="PovRayException">There is none; the message says where it was looked for.</exception>
    public static string Find(string? givenPath, string searchPath)
    {
        if (givenPath is not null)
        {
            if (File.Exists(givenPath))
            {
                return Path.GetFullPath(givenPath);
            }

            return SearchPath.Find(givenPath, Names) ?? throw new PovRayException(
                $"--pov-path {givenPath}: neither POV-Ray itself nor a folder that holds {string.Join(" or ", Names)}. "
                    + $"Give the path of POV-Ray 3.7.");
        }

        return SearchPath.Find(searchPath, Names) ?? throw new PovRayException(
            $"POV-Ray is missing: no {string.Join(" or ", Names)} on the PATH. Install POV-Ray 3.7 (Debian, Ubuntu: "
                + $"apt install povray) or give --pov-path.");
    }

    /// <summary>Asks the program.</summary>
    /// <param name="program">Its file.</param>
    /// <returns>E.g. "3.7.0.10.unofficial", or <see cref="UnknownVersion"/>.</returns>
    /// <exception cref="PovRayException">
    /// It can't be started, does not answer, or is killed: frames of an unknown version would pass for others.
    /// </exception>
    public static async Task<string> VersionOfAsync(string program)
    {
        try
        {
            ProcessResult result = await new ChildProgram(program, ["--version"]) { TimeLimit = LongestAnswer }
                .RunAsync(CancellationToken.None).ConfigureAwait(false);
            Match version = Number().Match(result.Output + result.Error);
            return version.Success ? version.Groups[1].Value
                : result.ExitCode <= LastOwnExitCode ? UnknownVersion
                : throw new PovRayException(
                    $"{program} --version: was killed by signal {result.ExitCode - LastOwnExitCode}. Run it again.");
        }
        catch (TimeoutException exception)
        {
            throw new PovRayException($"{program} --version: does not answer. Give the path of POV-Ray 3.7 with --pov-path.", exception);
        }
    }

    [GeneratedRegex(@"POV-Ray (?:\w+ )*v?(\d+\.\d+\S*)")]
    private static partial Regex Number();
}

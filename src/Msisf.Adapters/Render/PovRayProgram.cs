using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Render;

/// <summary>Finds POV-Ray.</summary>
public static class PovRayProgram
{
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
}

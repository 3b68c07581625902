using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Time;
using Msisf.Stress.Time;
using Msisf.TestSupport;
using System.Globalization;

namespace Msisf.Stress.Engines;

/// <summary>Draws the same scene by both renderers, with the program itself.</summary>
/// <param name="folder">For patterns and images.</param>
/// <param name="grid">LDEM_4.</param>
/// <param name="ephemeris">Where the Sun is.</param>
/// <param name="pixels">Of an image, about.</param>
internal sealed class RendererScenes(TemporaryFolder folder, IGlobalGrid grid, IEphemeris ephemeris, int pixels)
{
    /// <summary>1, of the Sun's zenith distance below the camera: the twilight's far side, where peaks are still lit.</summary>
    private const double MinSunCosine = -0.1;

    // MJD: 2008 to 2030.
    private const double FirstTime = 54466.0;
    private const double LastTime = 62502.0;

    /// <summary>Draws a scene by day, or with the terminator in it.</summary>
    /// <param name="number">Of the camera; its kind goes round.</param>
    /// <param name="random">Draws the time.</param>
    /// <exception cref="InvalidOperationException">The program failed.</exception>
    public RendererImages Draw(int number, CaseRandom random)
    {
        (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, pixels);
        Vector3D position = camera.PositionBodyFixed;
        UnitQuaternion attitude = camera.MoonFromCamera;
        string[] scene =
        [
            "--fixed-state", string.Create(
                CultureInfo.InvariantCulture,
                $"{{{DayTime(position, random):R},{position.X:R},{position.Y:R},{position.Z:R},"
                    + $"{attitude.X:R},{attitude.Y:R},{attitude.Z:R},{attitude.W:R}}}"),
            "--fov", double.RadiansToDegrees(camera.FieldOfView).ToString("R", CultureInfo.InvariantCulture),
            "--width", camera.Width.ToString(CultureInfo.InvariantCulture),
            "--height", camera.Height.ToString(CultureInfo.InvariantCulture),
        ];
        return new RendererImages(
            $"{kind}: {string.Join(' ', scene)}",
            position.Length,
            Run("povray", [.. scene, "--lod", "off", "--pov-options", "Antialias=Off", "--pattern-repos", folder["patterns"]]),
            Run("native", [.. scene, "--renderer", "native", "--reflectance", "lambert", "--lod", "off"]));
    }

    private double DayTime(Vector3D position, CaseRandom random)
    {
        while (true)
        {
            double mjd = random.Between(FirstTime, LastTime);
            Vector3D sun = ephemeris.SunPositionBodyFixed(ProjectKernels.OfMjd(mjd));
            if (Vector3D.Dot(sun.Normalized(), position.Normalized()) >= MinSunCosine)
            {
                return mjd;
            }
        }
    }

    private PngPixels Run(string name, string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. arguments, "--output-name", name, "--output-dir", folder.Path, "--ldem", TestParts.Ldem4Label!, "--ephemeris",
             "builtin", "--batch"]);
        return run.ExitCode == 0
            ? PngPixels.Read(folder[name + ".png"])
            : throw new InvalidOperationException($"{string.Join(' ', arguments)}: {run.Error}");
    }
}

using System.Globalization;
using System.Text;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Render;

/// <summary>Lambert's law and the grey scale against what POV-Ray makes of facets with the texture of our scenes.</summary>
public sealed class GreyScaleTests : IDisposable
{
    private const int Facets = 512;

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("msisf-grey-");

    public void Dispose() => _folder.Delete(recursive: true);

    [RequiresTheory(Part.PovRay)]
    [InlineData("+FN8", 255)]
    [InlineData("+FN16", 65535)]
    public void Level_FacetsFromTerminatorToSubSolarPoint_AreThoseOfPovRay(string fileType, int white)
    {
        PngPixels image = Render(fileType);
        GreyScale scale = new();
        IReflectance law = ReflectanceFactory.Create("lambert", new Dictionary<string, double>());

        for (int i = 0; i < Facets; i++)
        {
            // POV-Ray keeps colours as 32-bit floats: 1 of 65535 in about one of a thousand facets.
            int expected = scale.Level(law.RadianceFactor(CosIncidence(i), CosIncidence(i), 0.0), white);
            Assert.InRange(image[i, 1, 0], white == 255 ? expected : expected - 1, white == 255 ? expected : expected + 1);
        }
    }

    private static double CosIncidence(int facet) => (facet + 0.5) / Facets;

    /// <summary>One pixel column a facet, seen along the light: the scene's own texture and gamma, as PovSceneWriter has them.</summary>
    private PngPixels Render(string fileType)
    {
        StringBuilder scene = new(
            $$"""
            #version 3.7;
            global_settings { assumed_gamma 1.0 }
            #declare moon = texture { pigment { color rgb<0.8, 0.8, 0.8> } finish { ambient 0.0 diffuse 0.8 } }
            camera { orthographic location <0, 0, 1e5> right {{Facets}}*x up 4*y direction -z }
            light_source { <0, 0, 1e8> color rgb<1, 1, 1> parallel point_at 0 }

            """);
        for (int i = 0; i < Facets; i++)
        {
            int left = i - (Facets / 2);
            double slope = Math.Sqrt(1.0 - (CosIncidence(i) * CosIncidence(i))) / CosIncidence(i);
            scene.Append(
                CultureInfo.InvariantCulture,
                $"mesh2 {{ vertex_vectors {{ 4, <{left},-3,{3 * slope:R}>, <{left + 1},-3,{3 * slope:R}>, <{left + 1},3,{-3 * slope:R}>, "
                    + $"<{left},3,{-3 * slope:R}> }} ");
            scene.Append("face_indices { 2, <0,1,2>, <0,2,3> } texture { moon } }\n");
        }

        string scenePath = Path.Combine(_folder.FullName, "facets.pov");
        string imagePath = Path.Combine(_folder.FullName, "facets.png");
        File.WriteAllText(scenePath, scene.ToString());
        string[] arguments = [scenePath, "+O" + imagePath, $"+W{Facets}", "+H4", "-A", "-D", fileType];
        ChildRun.Of(TestParts.Program("povray")!, arguments, _folder.FullName).Succeeded();
        return PngPixels.Read(imagePath);
    }
}

using System.Reflection;
using Xunit;

namespace Msisf.Architecture.Tests
{
    /// <summary>No namespace uses another in a circle, parents and children counted; Core's have an order.</summary>
    public sealed class NamespaceCycleTests
    {
        /// <summary>The layers of Core, the lowest first: the data flow, in which a namespace uses only those before it.</summary>
        private static readonly string[] CoreLayers =
        [
            "Errors", "Numerics", "Parallel", "Time",
            "Terrain", // samples and places on the globe, which pointings and cameras are given by
            "Ephemeris", "Orbit", "Attitude",
            "Camera.Lenses", "Camera",
            "Surface", "Surface.Sources",
            "Lod",
            "Tracing",
            "Illumination", // light over time, without an image
            "Tiles", "Scene",
            "Render.Visibility", "Render.Photometry", "Render.Options", "Render.Shadows", "Render.Shading", "Render.Indirect",
            "Render.Sampling", "Render",
            "Blocks", "Tiles.Selection", "Preview",
            "Certainty", "Sensitivity",
            "Detector.Noise", "Detector.Psf", "Detector",
            "Navigation", "Sky",
            "Maps",
            "Metadata", "Layers",
        ];

        [Fact]
        public void NamespacesOfCore_Use_OnlyLayersBelow()
        {
            const string Core = "Msisf.Core.";
            (string User, string Used, string By)[] uses = [.. new NamespaceGraph(Assembly.Load("Msisf.Core").GetTypes()).Uses
                .Where(use => use.User.StartsWith(Core, StringComparison.Ordinal) && use.Used.StartsWith(Core, StringComparison.Ordinal))
                .Select(use => (use.User[Core.Length..], use.Used[Core.Length..], use.By))];

            string[] all = [.. uses.SelectMany(use => new[] { use.User, use.Used }).Distinct()];
            Assert.Equal(CoreLayers.Order(StringComparer.Ordinal), all.Order(StringComparer.Ordinal));
            Assert.Empty(uses
                .Where(use => Array.IndexOf(CoreLayers, use.User) < Array.IndexOf(CoreLayers, use.Used))
                .Select(use => $"{use.User} -> {use.Used} (by {use.By})"));
        }

        [Theory]
        [InlineData("Msisf.Synthesis")]
        [InlineData("Msisf.Adapters")]
        [InlineData("Msisf.MySql")]
        [InlineData("Msisf.App")]
        [InlineData("msis")]
        [InlineData("msis-server")]
        public void Namespaces_DoNotUseEachOther_InACircle(string assembly)
        {
            IReadOnlyList<string> cycles = new NamespaceGraph(Assembly.Load(assembly).GetTypes()).Cycles();

            Assert.True(cycles.Count == 0, $"{assembly}:\n{string.Join('\n', cycles)}");
        }

        /// <summary>The test of the test: a way through a method's body, a signature, and a type argument of a field.</summary>
        [Fact]
        public void Cycles_OfACircleOfThree_NamesItAndWhoMakesIt()
        {
            IEnumerable<Type> circle = typeof(NamespaceCycleTests).Assembly.GetTypes()
                .Where(type => type.Namespace is "Circle.A" or "Circle.B" or "Circle.C");

            string cycle = Assert.Single(new NamespaceGraph(circle).Cycles());

            Assert.Equal(
                "Circle.A -> Circle.B (by InBody's InSignature) -> Circle.C (by InSignature's InField) -> Circle.A (by InField's InBody)",
                cycle);
        }

        [Fact]
        public void Cycles_OfANamespaceAndOneInsideIt_AreCircles() =>
            Assert.Equal(
                ["Circle.A -> Circle.A.Inside (by InBody's User) -> Circle.A (by User's InBody)"],
                new NamespaceGraph([typeof(Circle.A.InBody), typeof(Circle.A.Inside.User)]).Cycles());
    }
}

namespace Circle.A
{
    internal sealed class InBody
    {
        public static string Name() => new B.InSignature().ToString()!;

        public static Type Part() => typeof(Inside.User);
    }
}

namespace Circle.A.Inside
{
    internal static class User
    {
        public static string Name() => InBody.Name();
    }
}

namespace Circle.B
{
    internal sealed class InSignature
    {
        public static void Take(C.InField _)
        {
        }
    }
}

namespace Circle.C
{
    internal sealed class InField
    {
        public IReadOnlyList<Func<A.InBody>> Parts { get; } = [];
    }
}

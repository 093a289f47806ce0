-- ghc -v0 -O0 -outputdir . -o diagrams {} && ./diagrams
-- Haskell's diagrams, rayTraceP of a sphere, in doubles: the first point where a ray from a point in a direction meets it, or
-- Nothing. Debian: libghc-diagrams-lib-dev. Source: Diagrams.Trace and Diagrams.ThreeD.Shapes: the unit sphere about the
-- origin, scaled and moved here. Silent on tangents.
-- raycheck returns point
-- raycheck root nearest
-- raycheck tangent either
-- raycheck level ordinary
import Diagrams.Prelude
import Diagrams.ThreeD.Shapes (sphere)
import System.IO

answer :: [Double] -> String
answer [ox, oy, oz, dx, dy, dz, cx, cy, cz, r] =
  case rayTraceP (mkP3 ox oy oz) (mkR3 dx dy dz) (sphere # scale r # translate (mkR3 cx cy cz)) of
    Nothing -> "= miss"
    Just point -> let (x, y, z) = unp3 point in unwords ("=" : map show [x, y, z])

main :: IO ()
main = hSetBuffering stdout LineBuffering >> getContents >>= mapM_ (putStrLn . answer . map read . words) . lines
